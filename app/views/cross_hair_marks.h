#pragma once

#include "app/views/pane.h"
#include "app/views/scene.h"
#include "app/workspace/objects_seen.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// CrossHairSight: whether what the 3D view shows hides the place where the slices meet; kept until camera, place or surface
// are others.
struct CrossHairSight {
  ObjectsSeen<1> from;
  glm::vec3 eye{0}, place{0};
  bool hidden = false;

  // update: of a surface every triangle is looked at, which waits until the camera rests.
  void update(const Workspace& workspace, bool moving);
};

// isBehindVolume: whether a ray from the eye meets the surface of a volume, as it is shown, before it has come to a place.
bool isBehindVolume(const VolumeScene& scene, const glm::vec3& eye, const glm::vec3& place);

// drawCrossHairInSpace: where the slices meet, as the 3D view's camera sees it: a small ring, and faint lines through the volume
// in the colours of the planes that they cross; where it is hidden, a faint ring alone.
void drawCrossHairInSpace(const PaneInput& pane, const Workspace& workspace, bool hidden);

}  // namespace sonoskin::ui
