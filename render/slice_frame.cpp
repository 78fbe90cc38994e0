#include "render/slice_frame.h"

#include <algorithm>

namespace sonoskin {

glm::vec3 planeColour(Plane plane) {
  switch (plane) {
    case Plane::sagittal:
      return {0.93f, 0.79f, 0.24f};
    case Plane::coronal:
      return {0.36f, 0.74f, 0.38f};
    case Plane::axial:
      return {0.91f, 0.34f, 0.29f};
  }
  return {};
}

glm::dvec2 SliceFrame::toPixel(const glm::dvec3& world) const {
  const glm::dvec3 d = world - corner;
  return {glm::dot(d, right) / glm::dot(right, right), glm::dot(d, down) / glm::dot(down, down)};
}

SliceFrame sliceFrame(const Geometry& geometry, const SliceCamera& camera, glm::ivec2 size) {
  const int r = axisRight(camera.plane), d = axisDown(camera.plane), a = axisAcross(camera.plane);
  // Voxels reach half a spacing beyond their centres.
  const glm::dvec2 extent(geometry.spacing[r] * geometry.dims[r], geometry.spacing[d] * geometry.dims[d]);
  const double mm = std::max(extent.x / size.x, extent.y / size.y) / camera.zoom;
  const glm::dvec3 rightward = geometry.direction[r], downward = geometry.direction[d];
  glm::dvec3 middle = 0.5 * glm::dvec3(geometry.dims - 1);
  middle[a] = geometry.toIndex(camera.cursor)[a];
  const glm::dvec2 offset = camera.pan + 0.5 * mm * glm::dvec2(size);
  SliceFrame frame;
  frame.right = mm * rightward;
  frame.down = mm * downward;
  frame.corner = geometry.toWorld(middle) - offset.x * rightward - offset.y * downward;
  return frame;
}

}  // namespace sonoskin
