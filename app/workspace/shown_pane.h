#pragma once

#include <glm/glm.hpp>

#include "app/workspace/view_state.h"

namespace sonoskin {

// ShownPane: a view that was drawn in this frame, and where, in pixels of the screen.
//   compared  a slice or a ray-cast whose layer is given, beside others
struct ShownPane {
  Pane pane;
  glm::vec2 corner, size;
  bool compared = false;
};

}  // namespace sonoskin
