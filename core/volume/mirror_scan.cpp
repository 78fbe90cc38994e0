#include "core/volume/mirror_scan.h"

namespace sonoskin {
namespace {

// Of what shares a grid with other threads' readers, a copy is placed elsewhere.
template <class T>
void place(std::shared_ptr<const Volume<T>>& volume, const Geometry& geometry) {
  if (!volume) return;
  auto placed = std::make_shared<Volume<T>>(*volume);
  placed->geometry = geometry;
  volume = std::move(placed);
}

}  // namespace

void mirrorScan(Scan& scan, MirroredAxis mirrored) {
  if (mirrored == MirroredAxis::none) return;
  const int axis = int(mirrored) - 1;
  Geometry geometry = scan.volume->geometry;
  const glm::dvec3 normal = geometry.direction[axis];
  const glm::dvec3 middle = geometry.toWorld(0.5 * glm::dvec3(geometry.dims - 1));
  const auto over = [&](const glm::dvec3& direction) {
    return direction - 2 * glm::dot(direction, normal) * normal;
  };
  geometry.origin = middle + over(geometry.origin - middle);
  geometry.direction[axis] = -normal;
  if (scan.beam) {
    if (scan.beam->apex) scan.beam->apex = middle + over(*scan.beam->apex - middle);
    scan.beam->axis = over(scan.beam->axis);
    scan.beam->up = over(scan.beam->up);
  }
  place(scan.volume, geometry);
  place(scan.mask, geometry);
  place(scan.erased, geometry);
  scan.key = Hasher("mirrored").add(scan.key).add(axis).key();
}

}  // namespace sonoskin
