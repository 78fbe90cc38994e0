#include "render/slice_frame.h"

#include <algorithm>

namespace sonoskin {

glm::dvec2 SliceFrame::toPixel(const glm::dvec3& world) const {
  const glm::dvec3 d = world - corner;
  return {glm::dot(d, right) / glm::dot(right, right), glm::dot(d, down) / glm::dot(down, down)};
}

namespace {

// The volume's middle, brought to the plane, is in the middle of the picture: the picture stays where it is while the cross-hair
// moves in the plane.
SliceFrame obliqueFrame(const Geometry& g, const SliceCamera& camera, glm::ivec2 size) {
  const PlaneDirections& plane = *camera.oblique;
  const glm::dvec3 n = plane.normal(), sides = g.spacing * glm::dvec3(g.dims);
  const double longest = std::max({sides.x, sides.y, sides.z});
  const double mm = longest / std::min(size.x, size.y) / camera.zoom;
  const glm::dvec3 middle = g.toWorld(0.5 * glm::dvec3(g.dims - 1));
  const glm::dvec3 onPlane = middle + glm::dot(camera.cursor - middle, n) * n;
  const glm::dvec2 offset = camera.pan + 0.5 * mm * glm::dvec2(size);
  return {onPlane - offset.x * plane.right - offset.y * plane.down, mm * plane.right, mm * plane.down};
}

}  // namespace

SliceFrame sliceFrame(const Geometry& geometry, const SliceCamera& camera, glm::ivec2 size) {
  if (camera.oblique) return obliqueFrame(geometry, camera, size);
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
