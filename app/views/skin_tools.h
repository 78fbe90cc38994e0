#pragma once

#include <glm/glm.hpp>

#include "app/views/pane.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// SkinTools: what the mouse holds in the 3D view while it shows skin.
//   grip     from the mouse to what it holds, pixels
//   turning  the wheel has changed the lamp's distance, which is not a step for undo yet
struct SkinTools {
  enum class Held { nothing, lamp, divider } held = Held::nothing;
  glm::vec2 grip{0};
  bool turning = false;
};

// useSkinTools: places a landmark, moves the lamp or the line between the halves.
//   output  what is left of the mouse for the camera
PaneInput useSkinTools(SkinTools& tools, Workspace& workspace, const PaneInput& pane);

// drawSkinMarks: lamp, line between the halves, landmarks, and how far light spreads.
void drawSkinMarks(const SkinTools& tools, const Workspace& workspace, const PaneInput& pane);

}  // namespace sonoskin::ui
