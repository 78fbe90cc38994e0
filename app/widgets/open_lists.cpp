#include "app/widgets/open_lists.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <string>
#include <string_view>

namespace sonoskin::ui {

int openLists() {
  const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
  if (open.empty()) return 0;
  const ImGuiWindow* window = open.back().Window;
  const bool asks = window && (window->Flags & ImGuiWindowFlags_Modal);
  return asks ? 0 : open.Size;
}

// One alone would open again where the mouse rests on its line.
void closeLists() {
  const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
  int level = open.Size;
  while (level > 0 && !(open[level - 1].Window && (open[level - 1].Window->Flags & ImGuiWindowFlags_Modal)))
    --level;
  if (level < open.Size) ImGui::ClosePopupToLevel(level, true);
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

bool popupIsOpen() { return !ImGui::GetCurrentContext()->OpenPopupStack.empty(); }

bool questionIsOpen() { return popupIsOpen() && !listIsOpen(); }

void leaveField() { ImGui::ClearActiveID(); }

bool mainHasKeys() {
  const ImGuiWindow* window = ImGui::GetCurrentContext()->NavWindow;
  return !window || std::string_view(window->RootWindow->Name) == "main";
}

bool focusChild(const char* name) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  for (ImGuiWindow* window : context.Windows) {
    const bool isChild = (window->Flags & ImGuiWindowFlags_ChildWindow) && window->WasActive;
    if (!isChild ||
        std::string_view(window->Name).find(std::string("/") + name + "_") == std::string_view::npos ||
        window->ParentWindow != window->RootWindow)
      continue;
    context.IO.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::FocusWindow(window);
    ImGui::NavInitWindow(window, true);
    context.NavDisableHighlight = false;
    context.NavDisableMouseHover = true;
    return true;
  }
  return false;
}

void steerByKeys(const KeySteering& steering) {
  ImGuiIO& io = ImGui::GetIO();
  // Of itself it goes from text field to text field, and past all else.
  if (questionIsOpen() || (mainHasKeys() && !io.WantTextInput))
    io.KeysDown[ImGui::GetKeyIndex(ImGuiKey_Tab)] = false;
  if (!popupIsOpen() && !steering.widgets) {
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    return;
  }
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  if (steering.step > 0) io.NavInputs[ImGuiNavInput_DpadDown] = 1;
  if (steering.step < 0) io.NavInputs[ImGuiNavInput_DpadUp] = 1;
  if (steering.questionStep != 0) {
    io.NavInputs[steering.questionStep > 0 ? ImGuiNavInput_DpadRight : ImGuiNavInput_DpadLeft] = 1;
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
    ImGui::GetCurrentContext()->NavDisableMouseHover = true;
  }
  // This version of ImGui takes the space bar alone for "do it".
  const bool isEnter = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Enter));
  if (isEnter && !io.WantTextInput) io.NavInputs[ImGuiNavInput_Activate] = 1;
}

// ImGui looks for the next line right below the last, and finds none beyond a gap: then it is whatever lies nearest there.
void stepOn() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool sideways = context.NavMoveDir == ImGuiDir_Left || context.NavMoveDir == ImGuiDir_Right;
  if (!context.NavWindow || !sideways || !questionIsOpen()) return;
  if (!(context.NavMoveFlags & ImGuiNavMoveFlags_Forwarded))
    return ImGui::NavMoveRequestTryWrapping(context.NavWindow, ImGuiNavMoveFlags_WrapX);
  const ImGuiDir on = context.NavMoveDir == ImGuiDir_Right ? ImGuiDir_Down : ImGuiDir_Up;
  if (ImGui::NavMoveRequestButNoResultYet()) ImGui::NavMoveRequestForward(on, on, 0, 0);
}

}  // namespace sonoskin::ui
