#include <imgui.h>

#include "app/panels/panels.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {

void drawQuestion(Workspace& workspace) {
  constexpr const char* kTitle = "Unsaved work";
  if (!workspace.question) return;
  if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
    return;
  ImGui::PushTextWrapPos(360 * unit());
  ImGui::Text("%s loses the surface or the erased parts, which are not saved.",
              workspace.question->what.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  const ImVec2 size{112 * unit(), 0};
  const bool stays = ImGui::Button("Go back", size);
  noteWidget("question.back");
  ImGui::SameLine();
  const bool goesOn = ImGui::Button("Discard", size);
  noteWidget("question.discard");
  if (stays || goesOn) {
    const auto action = std::move(workspace.question->action);
    workspace.question.reset();
    ImGui::CloseCurrentPopup();
    if (goesOn) action();
  }
  ImGui::EndPopup();
}

}  // namespace sonoskin::ui
