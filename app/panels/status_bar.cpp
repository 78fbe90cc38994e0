#include <fmt/format.h>
#include <imgui.h>

#include <glm/glm.hpp>
#include <numeric>

#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

// The grey value under the cross-hair: of the file and normalised.
std::string valueAt(const Scan& scan, const glm::ivec3& v) {
  const double normalised = double(scan.volume->at(v.x, v.y, v.z));
  const double original = scan.originalMin + normalised * (scan.originalMax - scan.originalMin);
  return fmt::format("{:.0f} ({:.2f})", original, normalised);
}

void cell(const char* label, const std::string& value, const ImVec4& colour = colours().text) {
  ImGui::TextDisabled("%s", tr(label));
  ImGui::SameLine(0, 5 * unit());
  ImGui::TextColored(colour, "%s", value.c_str());
  ImGui::SameLine(0, 22 * unit());
}

void drawScanCells(const Scan& scan, const glm::dvec3& cursor) {
  const Geometry& g = scan.volume->geometry;
  cell("Volume", fmt::format("{} × {} × {}", g.dims.x, g.dims.y, g.dims.z));
  if (scan.spacingKnown) {
    cell("Spacing", fmt::format("{} × {} × {} mm", millimetres(g.spacing.x), millimetres(g.spacing.y),
                                millimetres(g.spacing.z)));
  } else {
    cell("Spacing", tr("unknown"), colours().warning);
  }
  const glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::round(g.toIndex(cursor))), glm::ivec3(0), g.dims - 1);
  const glm::dvec3 world = g.toWorld(glm::dvec3(voxel));
  cell("Cross-hair",
       trf("{}, {}, {}  at {:.1f}, {:.1f}, {:.1f} mm", voxel.x, voxel.y, voxel.z, world.x, world.y, world.z));
  cell("Value", valueAt(scan, voxel));
}

void drawResultCells(const Session& session) {
  const Results& results = session.results();
  if (results.points) cell("Points", grouped(results.points->size()));
  if (results.mesh) {
    cell("Triangles", grouped(results.mesh->triangles.size()));
    cell("Area", fmt::format("{} mm²", grouped(static_cast<std::size_t>(session.meshArea() + 0.5))));
  }
  const double seconds =
      std::accumulate(results.stages.begin(), results.stages.end(), 0.0,
                      [](double sum, const StageReport& stage) { return sum + stage.seconds; });
  if (!results.stages.empty()) cell("Time", fmt::format("{:.2f} s", seconds));
}

// How many warnings were not seen yet; opens the log, or closes it.
void drawMessagesButton(MessageLog& log) {
  const std::string label = log.unseen == 1  ? std::string(tr("1 warning"))
                            : log.unseen > 0 ? trf("{} warnings", log.unseen)
                                             : std::string(tr("Messages"));
  const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width - 12 * unit());
  ImGui::PushStyleColor(ImGuiCol_Text, log.unseen > 0 ? colours().warning : colours().faintText);
  const bool pressed = ImGui::Button((label + "###messages").c_str());
  ImGui::PopStyleColor();
  noteWidget("status.messages");
  if (!pressed) return;
  if (log.shown)
    log.shown = false;
  else
    log.open();
}

}  // namespace

void drawStatusBar(Workspace& workspace) {
  const Session& session = workspace.session;
  const float top = ImGui::GetCursorPosY();
  ImGui::AlignTextToFramePadding();
  if (session.hasScan()) {
    drawScanCells(session.scan(), workspace.view.cursor);
    drawResultCells(session);
    ImGui::NewLine();
  } else {
    ImGui::TextDisabled("%s", tr("Drop a volume on the window, or press Ctrl+O"));
  }
  ImGui::SetCursorPosY(top);
  drawMessagesButton(workspace.toasts.log);
}

}  // namespace sonoskin::ui
