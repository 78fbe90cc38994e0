#pragma once

#include "app/views/pane.h"
#include "render/camera.h"
#include "render/slice_axes.h"

namespace sonoskin::ui {

// OrientationCube: a small cube in the lower left corner of the 3D view that turns with the camera. Its faces are lettered R, L,
// A, P, S, I, or in a scanner's frame by what lies there; a click on one looks at it from its side.
struct OrientationCube {
  bool held = false;  // has had the left button since it went down
};

// useCube: what the mouse does to it.
//   output  what is left of the mouse; `camera` and `moved` where a face was clicked
PaneInput useCube(OrientationCube& cube, const ViewFrame& frame, const PaneInput& pane, Camera& camera,
                  bool& moved);

// drawCube: its faces that are toward the camera; the one below the mouse is lighter.
void drawCube(const OrientationCube& cube, const ViewFrame& frame, const PaneInput& pane,
              const Camera& camera);

// lookFrom: the camera turned about its target so that it sees the scan from a side, as upright as that side allows.
//   side  unit, world: from the target toward where it looks from
void lookFrom(const glm::dvec3& side, const ViewFrame& frame, Camera& camera);

}  // namespace sonoskin::ui
