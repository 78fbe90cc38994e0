#include "render/slice_frame.h"

#include <algorithm>

namespace sonoskin {

glm::dvec2 SliceFrame::toPixel(const glm::dvec3& world) const {
  const glm::dvec3 d = world - corner;
  return {glm::dot(d, right) / glm::dot(right, right), glm::dot(d, down) / glm::dot(down, down)};
}

SliceFrame sliceFrame(const Geometry& geometry, const SliceCamera& camera, glm::ivec2 size) {
  const SliceAxes& axes = camera.axes();
  const int r = axes.right, d = axes.down, a = axes.across;
  // Voxels reach half a spacing beyond their centres.
  const glm::dvec2 extent(geometry.spacing[r] * geometry.dims[r], geometry.spacing[d] * geometry.dims[d]);
  const double mm = std::max(extent.x / size.x, extent.y / size.y) / camera.zoom;
  const glm::dvec3 rightward = (axes.rightGrows ? 1.0 : -1.0) * geometry.direction[r];
  const glm::dvec3 downward = (axes.downGrows ? 1.0 : -1.0) * geometry.direction[d];
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
