#include "app/workspace/cursor_steps.h"

namespace sonoskin {

glm::dvec3 inVolume(const Geometry& geometry, const glm::dvec3& world) {
  return geometry.toWorld(glm::clamp(geometry.toIndex(world), glm::dvec3(0), glm::dvec3(geometry.dims - 1)));
}

glm::dvec3 onVoxel(const Geometry& geometry, const glm::dvec3& world) {
  const glm::dvec3 index = glm::clamp(geometry.toIndex(world), glm::dvec3(0), glm::dvec3(geometry.dims - 1));
  return geometry.toWorld(glm::round(index));
}

void stepCursor(ViewState& view, const Geometry& geometry, Plane plane, const glm::ivec3& steps) {
  const SliceAxes& axes = view.planes[plane];
  glm::dvec3 index = geometry.toIndex(view.cursor);
  index[axes.right] += axes.rightGrows ? steps.x : -steps.x;
  index[axes.down] += axes.downGrows ? steps.y : -steps.y;
  index[axes.across] += axes.acrossGrows ? steps.z : -steps.z;
  view.cursor = onVoxel(geometry, geometry.toWorld(index));
}

void stepOblique(ViewState& view, const Geometry& geometry, const glm::dvec3& steps) {
  const PlaneDirections& plane = view.oblique.directions;
  const glm::dvec3 moved = steps.x * plane.right + steps.y * plane.down - steps.z * plane.normal();
  view.cursor = inVolume(geometry, view.cursor + geometry.minSpacing() * moved);
}

}  // namespace sonoskin
