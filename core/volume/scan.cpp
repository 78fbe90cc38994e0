#include "core/volume/scan.h"

#include <span>

#include "core/base/error.h"

namespace sonoskin {
namespace {

void addVector(Hasher& hasher, const glm::dvec3& v) { hasher.add(v.x).add(v.y).add(v.z); }

// The world direction that leads from one side of the volume to the opposite one.
glm::dvec3 inwardFrom(VolumeSide side, const Geometry& geometry) {
  const int axis = int(side) / 2;
  const double sign = int(side) % 2 ? -1 : 1;
  return sign * geometry.direction[axis];
}

}  // namespace

Beam beamOf(const Scan& scan, const ScanOptions& options) {
  if (scan.beam) return *scan.beam;
  require(int(options.probeSide) / 2 != int(options.topSide) / 2,
          "scan.probeSide and scan.topSide name the same or opposite sides: choose sides of different axes");
  Beam beam;
  beam.axis = inwardFrom(options.probeSide, scan.volume->geometry);
  beam.up = -inwardFrom(options.topSide, scan.volume->geometry);
  return beam;
}

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
    addVector(hasher, beam->up);
    hasher.add(beam->apex.has_value());
    if (beam->apex) addVector(hasher, *beam->apex);
  }
  hasher.add(std::span<const float>(volume.data));
  return hasher.key();
}

}  // namespace sonoskin
