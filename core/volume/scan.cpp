#include "core/volume/scan.h"

#include <span>

namespace sonoskin {
namespace {

void addVector(Hasher& hasher, const glm::dvec3& v) { hasher.add(v.x).add(v.y).add(v.z); }

}  // namespace

Key scanKey(const Volume<float>& volume, const std::optional<Beam>& beam) {
  Hasher hasher("scan");
  const Geometry& g = volume.geometry;
  hasher.add(g.dims.x).add(g.dims.y).add(g.dims.z);
  addVector(hasher, g.spacing);
  addVector(hasher, g.origin);
  for (int c = 0; c < 3; ++c) addVector(hasher, g.direction[c]);
  hasher.add(beam.has_value());
  if (beam) {
    addVector(hasher, beam->axis);
    hasher.add(beam->apex.has_value());
    if (beam->apex) addVector(hasher, *beam->apex);
  }
  hasher.add(std::span<const float>(volume.data));
  return hasher.key();
}

}  // namespace sonoskin
