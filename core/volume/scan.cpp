#include "core/volume/scan.h"

#include <algorithm>
#include <cmath>
#include <optional>
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

ScanOptions sidesApart(ScanOptions edited, const ScanOptions& before) {
  const auto axisOf = [](VolumeSide side) { return int(side) / 2; };
  if (axisOf(edited.probeSide) != axisOf(edited.topSide)) return edited;
  const bool probeWasEdited = edited.probeSide != before.probeSide;
  VolumeSide& other = probeWasEdited ? edited.topSide : edited.probeSide;
  other = probeWasEdited ? before.probeSide : before.topSide;
  if (axisOf(edited.probeSide) == axisOf(edited.topSide))  // both were edited, or turned over
    other = VolumeSide((int(other) / 2 * 2 + 2) % 6);
  return edited;
}

namespace {

// The voxel of another grid that a place in the world lies in; nothing outside.
std::optional<std::size_t> voxelAt(const Geometry& grid, const glm::dvec3& world) {
  const glm::dvec3 at =
      glm::floor(grid.toIndex(world) + 0.5);  // compared first: it may be beyond all integers
  const bool inside = glm::all(glm::greaterThanEqual(at, glm::dvec3(0))) &&
                      glm::all(glm::lessThan(at, glm::dvec3(grid.dims)));
  if (!inside) return {};
  const glm::ivec3 v(at);
  return grid.index(v.x, v.y, v.z);
}

// Whether voxels with the same index are the same: one grid, or a file that does not tell where it lies.
bool isSameGrid(const Scan& file, const Geometry& geometry) {
  constexpr double kSame = 1e-3;  // voxels
  const Geometry& g = file.volume->geometry;
  if (g.dims != geometry.dims) return false;
  if (!file.spacingKnown) return true;
  const glm::dvec3 last(g.dims - 1);
  const auto differs = [&](const glm::dvec3& at) {
    return glm::distance(geometry.toIndex(g.toWorld(at)), at) > kSame * (1 + glm::length(last));
  };
  return !differs({0, 0, 0}) && !differs(last) && !differs({last.x, 0, 0}) && !differs({0, last.y, 0});
}

// Where a volume that was read from a file was not zero there, on the scan's own grid; `name` is what a person calls it.
//   leastCovered  share of the scan's voxels that it must reach
Volume<std::uint8_t> notZeroInFile(const Scan& file, const Geometry& geometry, const char* name,
                                   double leastCovered) {
  const double zero = std::clamp(-file.originalMin / (file.originalMax - file.originalMin), 0.0,
                                 1.0);  // what 0 became when it was read
  const bool same = isSameGrid(file, geometry);
  const glm::ivec3 a = file.volume->geometry.dims, b = geometry.dims;
  require(same || file.spacingKnown,
          "the {} has {} x {} x {} voxels, but the volume {} x {} x {}, and does not say where it lies", name,
          a.x, a.y, a.z, b.x, b.y, b.z);
  Volume<std::uint8_t> marked(geometry);
  std::size_t covered = 0;
  for (int k = 0; k < geometry.dims.z; ++k)
    for (int j = 0; j < geometry.dims.y; ++j)
      for (int i = 0; i < geometry.dims.x; ++i) {
        const auto there = same ? std::optional(geometry.index(i, j, k))
                                : voxelAt(file.volume->geometry, geometry.toWorld(glm::dvec3(i, j, k)));
        if (!there) continue;
        ++covered;
        marked.at(i, j, k) = std::abs(double(file.volume->data[*there]) - zero) > 1e-6;
      }
  require(
      double(covered) > leastCovered * double(geometry.voxels()),
      "the {} does not lie where the volume is: both must be of the same scan, and say so in their headers",
      name);
  return marked;
}

bool isZero(const Volume<std::uint8_t>& volume) {
  return std::none_of(volume.data.begin(), volume.data.end(), [](std::uint8_t v) { return v != 0; });
}

}  // namespace

namespace {

bool isGiven(const std::array<double, 3>& spacing) {
  return std::ranges::all_of(spacing, [](double mm) { return mm > 0; });
}

glm::dvec3 spacingFrom(const std::array<double, 3>& given) {
  return isGiven(given) ? glm::dvec3(given[0], given[1], given[2]) : glm::dvec3(1);
}

}  // namespace

bool isSpaced(const Scan& scan, const std::array<double, 3>& spacing) {
  return scan.spacingKnown == isGiven(spacing) && scan.volume->geometry.spacing == spacingFrom(spacing);
}

void setSpacing(Scan& scan, const std::array<double, 3>& given) {
  scan.spacingKnown = isGiven(given);
  const glm::dvec3 spacing = spacingFrom(given);
  if (scan.volume->geometry.spacing == spacing) return;
  auto volume = std::make_shared<Volume<float>>(*scan.volume);
  volume->geometry.spacing = spacing;
  scan.key = scanKey(*volume, scan.beam);
  scan.volume = std::move(volume);
}

void setMask(Scan& scan, const Scan& mask) {
  auto inside =
      std::make_shared<Volume<std::uint8_t>>(notZeroInFile(mask, scan.volume->geometry, "mask", 0.5));
  require(!isZero(*inside), "the mask is zero everywhere: it must not be zero where something was scanned");
  if (scan.mask)  // what a probe did not scan is no part of the volume, whatever another mask says
    for (std::size_t v = 0; v < inside->data.size(); ++v) inside->data[v] &= scan.mask->data[v] != 0;
  scan.key = maskedKey(scan.key, *inside);
  scan.mask = std::move(inside);
}

void setErased(Scan& scan, const Scan& erased) {
  Volume<std::uint8_t> marked = notZeroInFile(erased, scan.volume->geometry, "erased volume", 0);
  require(!isZero(marked), "the erased volume is zero everywhere: it must not be zero where nothing counts");
  setErased(scan, std::move(marked));
}

void setErased(Scan& scan, Volume<std::uint8_t> erased) {
  scan.erasedKey = Hasher("erased").add(std::span<const std::uint8_t>(erased.data)).key();
  scan.erased = std::make_shared<const Volume<std::uint8_t>>(std::move(erased));
}

Key maskedKey(const Key& scan, const Volume<std::uint8_t>& mask) {
  return Hasher("masked").add(scan).add(std::span<const std::uint8_t>(mask.data)).key();
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
