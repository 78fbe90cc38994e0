#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/volume/convex_hull.h"

namespace sonoskin {

// The flat sides of a scanned sector, found among the faces of its hull. Positions are voxel index .* spacing, mm.

// SectorFrame: what directions mean.
//   axis     unit, of the middle beam, away from the probe
//   across   the two axes of the volume that are most nearly across the beams
//   extent   position of the volume's last voxel; the first one is at 0
//   voxel    smallest spacing, mm
struct SectorFrame {
  glm::dvec3 axis{0, 1, 0};
  std::array<int, 2> across{0, 2};
  glm::dvec3 extent{0};
  double voxel = 1;
};

// SectorSides: the sides toward -across[0], +across[0], -across[1], +across[1]; empty where none was found.
using SectorSides = std::array<std::optional<HullFace>, 4>;

// findSectorSides: the largest face toward each side that leans back from the beams or runs along them. The faces of
// the volume's own box are none: there the volume was cut, not the recording.
SectorSides findSectorSides(const std::vector<HullFace>& faces, const SectorFrame& frame);

// opensTowards: whether two opposite sides draw apart away from the probe, by 4 degrees or more.
bool opensTowards(const std::optional<HullFace>& low, const std::optional<HullFace>& high,
                  const glm::dvec3& axis);

// isAnatomy: whether a face that leans back does so unlike the sector's sides: there the hull lies on what was
// scanned.
bool isAnatomy(const HullFace& face, const SectorSides& sides, const SectorFrame& frame);

// sectorOrigin: the point with the least squared distances to the sides.
//   middle   the middle of the scanned region, for the coordinate that no side tells
//   output   none if no two opposite sides draw apart, or if they would meet within the region
std::optional<glm::dvec3> sectorOrigin(const SectorSides& sides, const SectorFrame& frame,
                                       const glm::dvec3& middle);

}  // namespace sonoskin
