#pragma once

#include <glm/glm.hpp>
#include <string>

#include "app/views/pane.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// PartTools: what the left button does in the 3D view while it shows parts.
//   held     a click that may still become a turn of the camera, or a stroke
//   from     where it went down, from the view's upper left corner
struct PartTools {
  enum class Held { nothing, click, stroke } held = Held::nothing;
  glm::vec2 from{0}, to{0};
  bool alone = false;  // Shift was down
};

// showsParts: whether the 3D view shows parts now.
bool showsParts(const Workspace& workspace);

// usePartTools: a click takes the part below the mouse away or brings it back, with Shift it leaves that part alone; a
// line drawn with Ctrl splits the part that it crosses.
//   output  what is left of the mouse for the camera
PaneInput usePartTools(PartTools& tools, Workspace& workspace, const PaneInput& pane);

// drawPartMarks: the line that is being drawn. partCaption: what is shown and what the mouse does.
void drawPartMarks(const PartTools& tools, const PaneInput& pane);
std::string partCaption(const Workspace& workspace);

}  // namespace sonoskin::ui
