#pragma once

#include <imgui.h>

namespace sonoskin::ui {

// DialogWindow: a window in the middle that asks nothing.
//   title  in the window's language; id: "###about", by which it stays the same in any
//   size   without scale; smaller where the screen is
struct DialogWindow {
  const char *title, *id;
  ImVec2 size;
};

// beginDialog: call ImGui::End() whatever it says.
//   shown   becomes false when its corner is clicked
//   output  whether anything of it is seen
bool beginDialog(const DialogWindow& dialog, bool& shown);

}  // namespace sonoskin::ui
