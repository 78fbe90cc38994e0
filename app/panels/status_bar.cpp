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

// Cell: a fact of the line.
struct Cell {
  const char* label;  // in English
  std::string value;
  bool warning = false;
};

void addScanCells(std::vector<Cell>& cells, const Scan& scan, const glm::dvec3& cursor) {
  const Geometry& g = scan.volume->geometry;
  cells.push_back({"Volume", fmt::format("{} × {} × {}", g.dims.x, g.dims.y, g.dims.z)});
  if (scan.spacingKnown) {
    cells.push_back({"Spacing", fmt::format("{} × {} × {} mm", millimetres(g.spacing.x),
                                            millimetres(g.spacing.y), millimetres(g.spacing.z))});
  } else {
    cells.push_back({"Spacing", tr("unknown"), true});
  }
  const glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::round(g.toIndex(cursor))), glm::ivec3(0), g.dims - 1);
  const glm::dvec3 world = g.toWorld(glm::dvec3(voxel));
  cells.push_back({"Cross-hair", trf("{}, {}, {}  at {:.1f}, {:.1f}, {:.1f} mm", voxel.x, voxel.y, voxel.z,
                                     world.x, world.y, world.z)});
  cells.push_back({"Value", valueAt(scan, voxel)});
}

void addResultCells(std::vector<Cell>& cells, const Session& session) {
  const Results& results = session.results();
  if (results.points) cells.push_back({"Points", grouped(results.points->size())});
  if (results.mesh) {
    cells.push_back({"Triangles", grouped(results.mesh->triangles.size())});
    cells.push_back(
        {"Area", fmt::format("{} mm²", grouped(static_cast<std::size_t>(session.meshArea() + 0.5)))});
  }
  const double seconds =
      std::accumulate(results.stages.begin(), results.stages.end(), 0.0,
                      [](double sum, const StageReport& stage) { return sum + stage.seconds; });
  if (!results.stages.empty()) cells.push_back({"Time", fmt::format("{:.2f} s", seconds)});
}

// From the left, as many as there is room for.
void drawCells(const std::vector<Cell>& cells, float room) {
  const float inner = 5 * unit(), outer = 22 * unit();
  for (const Cell& cell : cells) {
    const float width =
        ImGui::CalcTextSize(tr(cell.label)).x + inner + ImGui::CalcTextSize(cell.value.c_str()).x + outer;
    room -= width;
    if (room < 0) return;
    ImGui::TextDisabled("%s", tr(cell.label));
    ImGui::SameLine(0, inner);
    ImGui::TextColored(cell.warning ? colours().warning : colours().text, "%s", cell.value.c_str());
    ImGui::SameLine(0, outer);
  }
}

// How many warnings were not seen yet.
std::string messagesLabel(const MessageLog& log) {
  return log.unseen == 1  ? std::string(tr("1 warning"))
         : log.unseen > 0 ? trf("{} warnings", log.unseen)
                          : std::string(tr("Messages"));
}

float messagesWidth(const MessageLog& log) {
  return ImGui::CalcTextSize(messagesLabel(log).c_str()).x + 2 * ImGui::GetStyle().FramePadding.x +
         12 * unit();
}

// Opens the log, or closes it.
void drawMessagesButton(MessageLog& log) {
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - messagesWidth(log));
  ImGui::PushStyleColor(ImGuiCol_Text, log.unseen > 0 ? colours().warning : colours().faintText);
  const bool pressed = ImGui::Button((messagesLabel(log) + "###messages").c_str());
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
    std::vector<Cell> cells;
    addScanCells(cells, session.scan(), workspace.view.cursor);
    addResultCells(cells, session);
    drawCells(cells, ImGui::GetContentRegionAvail().x - messagesWidth(workspace.toasts.log));
    ImGui::NewLine();
  } else {
    ImGui::TextDisabled("%s", tr("Drop a volume on the window, or press Ctrl+O"));
  }
  ImGui::SetCursorPosY(top);
  drawMessagesButton(workspace.toasts.log);
}

}  // namespace sonoskin::ui
