#pragma once

#include <glm/glm.hpp>

#include "app/views/pane.h"

namespace sonoskin::ui {

// DoubleClick: a double click that shows a view alone leaves no trace of its two clicks: the cross-hair that the first one took
// along goes back, and the second one does nothing until its button is up, for the view below it is another one by then.
struct DoubleClick {
  glm::dvec3 cursorBefore{0};  // the last click
  bool blocked = false;

  // filter: one view in one frame.
  //   input   alone   whether it was double clicked, and is to be shown alone
  //   output  what is left of the mouse; `cursor` as it was before the first click
  PaneInput filter(const PaneInput& pane, bool alone, glm::dvec3& cursor);
};

}  // namespace sonoskin::ui
