#include <fmt/format.h>
#include <imgui.h>

#include <optional>

#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/step_title.h"

namespace sonoskin::ui {
namespace {

// The step that was pressed. Those that were taken back are faint.
std::optional<std::size_t> drawSteps(const History<Version>& history) {
  std::optional<std::size_t> pressed;
  ImGuiListClipper clipper;
  clipper.Begin(int(history.size()));
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto n = std::size_t(row);
      const std::string title = n == 0 ? tr("As it was opened") : stepTitle(history.at(n - 1), history.at(n));
      ImGui::PushStyleColor(ImGuiCol_Text, n > history.position() ? colours().faintText : colours().text);
      if (ImGui::Selectable(fmt::format("{}###step{}", title, n).c_str(), n == history.position()))
        pressed = n;
      ImGui::PopStyleColor();
      noteWidget(fmt::format("history.{}", n));
    }
  }
  return pressed;
}

}  // namespace

void drawHistory(Workspace& workspace) {
  if (!workspace.historyShown) return;
  const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
  ImGui::SetNextWindowPos(middle, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({320 * unit(), 360 * unit()}, ImGuiCond_Appearing);
  const std::string title = std::string(tr("History")) + "###history";
  if (ImGui::Begin(title.c_str(), &workspace.historyShown,
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    const auto pressed = drawSteps(workspace.session.history());
    if (pressed) workspace.session.goToStep(*pressed);
  }
  ImGui::End();
}

}  // namespace sonoskin::ui
