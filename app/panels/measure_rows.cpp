#include "app/panels/measure_rows.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

constexpr std::array<const char*, 3> kKinds{"Distance", "Angle", "Area"};
constexpr std::array<const char*, 3> kCommandIds{"measure.distance", "measure.angle", "measure.area"};

void drawKinds(Workspace& workspace) {
  const float gap = 4 * unit();
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  for (std::size_t n = 0; n < kKinds.size(); ++n) {
    const Command& command = sonoskin::command(kCommandIds[n]);
    const bool on = command.checked(workspace);
    if (n > 0) ImGui::SameLine(0, gap);
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(fmt::format("{}###{}", tr(kKinds[n]), command.id).c_str(), {width, 0}))
      command.run(workspace);
    noteWidget(command.id);
    if (on) ImGui::PopStyleColor();
  }
}

// Whether it is to be deleted.
bool drawMeasure(Workspace& workspace, std::size_t number) {
  const Measure& measure = workspace.view.measures[number];
  ImGui::PushID(int(number));
  const std::string text =
      fmt::format("{}   {}", tr(kKinds[std::size_t(measure.kind)]), measureText(measure));
  const float button = ImGui::GetFrameHeight();
  if (ImGui::Selectable(text.c_str(), false, 0, {ImGui::GetContentRegionAvail().x - button - 6 * unit(), 0}))
    workspace.view.cursor = measure.marks.front();
  ImGui::SameLine();
  const bool gone = ImGui::SmallButton("×");
  noteWidget(fmt::format("measure.{}.delete", number));
  ImGui::PopID();
  return gone;
}

}  // namespace

void drawMeasureRows(Workspace& workspace) {
  const DisabledIf disabled(!workspace.session.hasScan());
  drawKinds(workspace);
  auto& measures = workspace.view.measures;
  for (std::size_t n = 0; n < measures.size(); ++n)
    if (drawMeasure(workspace, n)) {
      measures.erase(measures.begin() + std::ptrdiff_t(n));
      break;
    }
}

}  // namespace sonoskin::ui
