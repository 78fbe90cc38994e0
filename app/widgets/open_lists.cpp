#include "app/widgets/open_lists.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace sonoskin::ui {

bool listIsOpen() {
  const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
  if (open.empty()) return false;
  const ImGuiWindow* window = open.back().Window;
  return !window || !(window->Flags & ImGuiWindowFlags_Modal);
}

void closeList() {
  if (listIsOpen()) ImGui::ClosePopupToLevel(ImGui::GetCurrentContext()->OpenPopupStack.Size - 1, true);
}

// The highlight of the keyboard is shown at once, and the mouse, which may rest on another menu, is not looked at until it moves.
void openMenu(const char* title) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.IO.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  ImGui::OpenPopup(title);
  context.NavDisableHighlight = false;
  context.NavDisableMouseHover = true;
}

void steerLists() {
  ImGuiIO& io = ImGui::GetIO();
  if (!listIsOpen()) {
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    return;
  }
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  // This version of ImGui takes the space bar alone for "do it".
  if (ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Enter))) io.NavInputs[ImGuiNavInput_Activate] = 1;
}

}  // namespace sonoskin::ui
