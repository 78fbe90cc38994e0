#include "app/widgets/open_lists.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace sonoskin::ui {

int openLists() {
  const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
  if (open.empty()) return 0;
  const ImGuiWindow* window = open.back().Window;
  const bool asks = window && (window->Flags & ImGuiWindowFlags_Modal);
  return asks ? 0 : open.Size;
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

// ImGui would close the menu and show no other.
int leavesMenu() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiWindow* window = context.NavWindow;
  const bool sideways = context.NavMoveDir == ImGuiDir_Left || context.NavMoveDir == ImGuiDir_Right;
  if (!window || window->ParentWindow != context.CurrentWindow ||
      !(window->Flags & ImGuiWindowFlags_ChildMenu))
    return 0;
  if (!sideways || !ImGui::NavMoveRequestButNoResultYet()) return 0;
  const int step = context.NavMoveDir == ImGuiDir_Right ? 1 : -1;
  ImGui::NavMoveRequestCancel();
  return step;
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
