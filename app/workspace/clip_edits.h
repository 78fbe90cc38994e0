#pragma once

#include <array>

#include "render/slice_frame.h"

namespace sonoskin {

struct Workspace;

// What is done with the plane that cuts what the 3D view shows (ViewState::clip). All of it needs a scan.

// switchClip: on or off; the first time it faces the camera, through the middle of what is shown.
void switchClip(Workspace& workspace);
// clipFromView: what lies nearer than the middle of what is shown is cut away. clipFromPlane: the plane of a slice, through the
// cross-hair; the side toward the camera is cut away. flipClip: what was cut away is kept, and the other way round.
void clipFromView(Workspace& workspace);
void clipFromPlane(Workspace& workspace, Plane plane);
void flipClip(Workspace& workspace);

// clipDepth: how far the plane lies from the middle of what is shown, mm along its normal. clipRange: the least and the most
// where it cuts anything. moveClip: to another depth, within that range.
float clipDepth(const Workspace& workspace);
std::array<float, 2> clipRange(const Workspace& workspace);
void moveClip(Workspace& workspace, float depth);
// clipMiddle: the place of the plane that is nearest to the middle of what is shown, world mm.
glm::vec3 clipMiddle(const Workspace& workspace);

}  // namespace sonoskin
