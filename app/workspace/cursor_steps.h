#pragma once

#include "app/workspace/view_state.h"

namespace sonoskin {

// inVolume: places outside of the volume are brought to its border.
glm::dvec3 inVolume(const Geometry& geometry, const glm::dvec3& world);
// onVoxel: the nearest voxel's centre, world mm; places outside of the volume are brought to its border.
glm::dvec3 onVoxel(const Geometry& geometry, const glm::dvec3& world);

// stepCursor: moves the cross-hair by voxels as a plane's picture shows it.
//   steps  to the right, downward, and to the slices toward the left, the front and the head, or deeper
void stepCursor(ViewState& view, const Geometry& geometry, Plane plane, const glm::ivec3& steps);

// stepOblique: the same as the oblique slice's picture shows it, by the smallest spacing.
//   steps  to the right, downward, and toward who looks at the picture
void stepOblique(ViewState& view, const Geometry& geometry, const glm::dvec3& steps);

}  // namespace sonoskin
