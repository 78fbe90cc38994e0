#include "core/volume/scan.h"

#include <algorithm>
#include <cmath>
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

LocalBeams::LocalBeams(const Beam& beam, const Geometry& geometry)
    : axis_(glm::transpose(geometry.direction) * beam.axis) {
  if (beam.apex) apex_ = glm::vec3(geometry.spacing * geometry.toIndex(*beam.apex));
}

namespace {

// Parallel beams from the side that the options name.
Beam beamFromSide(const Scan& scan, const ScanOptions& options) {
  require(int(options.probeSide) / 2 != int(options.topSide) / 2,
          "scan.probeSide and scan.topSide name the same or opposite sides: choose sides of different axes");
  Beam beam;
  beam.axis = inwardFrom(options.probeSide, scan.volume->geometry);
  beam.up = -inwardFrom(options.topSide, scan.volume->geometry);
  return beam;
}

}  // namespace

Beam beamOf(const Scan& scan, const ScanOptions& options) {
  Beam beam = scan.beam ? *scan.beam : beamFromSide(scan, options);
  if (options.beamOrigin == BeamOrigin::parallel) beam.apex.reset();
  if (options.beamOrigin == BeamOrigin::given)
    beam.apex = {options.apex[0], options.apex[1], options.apex[2]};
  return beam;
}

void setMask(Scan& scan, const Scan& mask) {
  const glm::ivec3 a = mask.volume->geometry.dims, b = scan.volume->geometry.dims;
  require(a == b, "the mask has {} x {} x {} voxels, but the volume {} x {} x {}: they must be the same", a.x,
          a.y, a.z, b.x, b.y, b.z);
  const double zero =
      -mask.originalMin / (mask.originalMax - mask.originalMin);  // what 0 became when it was read
  auto inside = std::make_shared<Volume<std::uint8_t>>(scan.volume->geometry);
  std::size_t count = 0;
  for (std::size_t v = 0; v < inside->data.size(); ++v) {
    inside->data[v] = std::abs(double(mask.volume->data[v]) - std::clamp(zero, 0.0, 1.0)) > 1e-6;
    count += inside->data[v];
  }
  require(count > 0, "the mask is zero everywhere: it must not be zero where something was scanned");
  scan.key = Hasher("masked").add(scan.key).add(std::span<const std::uint8_t>(inside->data)).key();
  scan.mask = std::move(inside);
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
