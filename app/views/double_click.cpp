#include "app/views/double_click.h"

namespace sonoskin::ui {

PaneInput DoubleClick::filter(const PaneInput& pane, bool alone, glm::dvec3& cursor) {
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) blocked = false;
  if (alone) {
    blocked = true;
    cursor = cursorBefore;
  } else if (pane.pressed && !blocked) {
    cursorBefore = cursor;
  }
  return blocked ? withoutButton(pane) : pane;
}

}  // namespace sonoskin::ui
