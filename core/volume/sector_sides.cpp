#include "core/volume/sector_sides.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

constexpr double kSteepest = 0.85;    // sine of the largest lean of a side, 58 degrees
constexpr double kLeast = 0.03;       // sine of the least lean that tells of a sector, 2 degrees
constexpr double kSmallest = 0.005;   // share of the hull's surface that a side takes at least
constexpr double kAlike = 0.98;       // cosine: sides and their pieces are 11 degrees apart at most
constexpr double kBeyondSide = 0.75;  // sine of a lean that is anatomy where no side is known, 49 degrees

// How far a face looks back at the probe: the sine of its angle to the middle beam, negative for parts of a sector.
double leanOf(const HullFace& face, const glm::dvec3& axis) { return glm::dot(face.normal, axis); }

glm::dvec3 directionOf(std::size_t side, const SectorFrame& frame) {
  glm::dvec3 direction(0);
  direction[frame.across[side / 2]] = side % 2 ? 1 : -1;
  return direction;
}

bool isBoxFace(const HullFace& face, const SectorFrame& frame) {
  for (int a = 0; a < 3; ++a) {
    if (std::abs(face.normal[a]) < 0.9995) continue;
    const double border = face.normal[a] > 0 ? frame.extent[a] : 0;
    return std::abs(std::abs(face.offset) - border) < 0.6 * frame.voxel;
  }
  return false;
}

// The side that a face belongs to by its direction.
std::size_t sideOf(const HullFace& face, const SectorFrame& frame) {
  const double first = face.normal[frame.across[0]], second = face.normal[frame.across[1]];
  if (std::abs(first) >= std::abs(second)) return first < 0 ? 0 : 1;
  return second < 0 ? 2 : 3;
}

}  // namespace

SectorSides findSectorSides(const std::vector<HullFace>& faces, const SectorFrame& frame) {
  double surface = 0;
  for (const HullFace& face : faces) surface += face.area;
  SectorSides sides;
  for (const HullFace& face : faces) {
    const std::size_t side = sideOf(face, frame);
    const double lean = leanOf(face, frame.axis);
    const bool flat = std::abs(face.normal[frame.across[1 - side / 2]]) < 0.3;
    if (sides[side] || !flat || lean < -kSteepest || lean > kLeast || face.area < kSmallest * surface)
      continue;
    if (glm::dot(face.normal, directionOf(side, frame)) < 0.5 || isBoxFace(face, frame)) continue;
    sides[side] = face;
  }
  return sides;
}

bool opensTowards(const std::optional<HullFace>& low, const std::optional<HullFace>& high,
                  const glm::dvec3& axis) {
  return low && high && leanOf(*low, axis) + leanOf(*high, axis) < -2 * kLeast;
}

bool isAnatomy(const HullFace& face, const SectorSides& sides, const SectorFrame& frame) {
  const double lean = leanOf(face, frame.axis);
  if (lean >= -0.15) return false;
  const auto& side = sides[sideOf(face, frame)];
  return side ? glm::dot(face.normal, side->normal) < kAlike : lean < -kBeyondSide;
}

std::optional<glm::dvec3> sectorOrigin(const SectorSides& sides, const SectorFrame& frame,
                                       const glm::dvec3& middle) {
  if (!opensTowards(sides[0], sides[1], frame.axis) && !opensTowards(sides[2], sides[3], frame.axis))
    return {};
  constexpr double kPrior = 1e-4;
  glm::dmat3 matrix(kPrior);
  glm::dvec3 right = kPrior * middle;
  for (const auto& side : sides) {
    if (!side || leanOf(*side, frame.axis) > -kLeast) continue;
    matrix += glm::outerProduct(side->normal, side->normal);
    right -= side->offset * side->normal;
  }
  const glm::dvec3 origin = glm::inverse(matrix) * right;
  return glm::dot(middle - origin, frame.axis) > 0 ? std::optional(origin) : std::nullopt;
}

}  // namespace sonoskin
