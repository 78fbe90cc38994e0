#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// SectorGrid: the samples of a 3D probe, beams from one apex. Sample (i, j, k) lies at range firstRange + i *
// rangeStep, at the lateral angle and the elevation angle that count from -angle to +angle. At angles 0 the
// beam points along world y. Memory order: i fastest, then j.
struct SectorGrid {
  int ranges, laterals, elevations;
  float firstRange, rangeStep;         // mm
  float lateralAngle, elevationAngle;  // half openings, rad
  glm::vec3 apex;                      // world mm

  std::size_t samples() const {
    return std::size_t(ranges) * std::size_t(laterals) * std::size_t(elevations);
  }
  std::size_t row(int j, int k) const {
    return (std::size_t(k) * std::size_t(laterals) + std::size_t(j)) * std::size_t(ranges);
  }
  float lateralStep() const { return 2 * lateralAngle / float(laterals - 1); }        // rad
  float elevationStep() const { return 2 * elevationAngle / float(elevations - 1); }  // rad
  float lastRange() const { return firstRange + rangeStep * float(ranges - 1); }

  // beam: unit direction of beam (j, k): lateral angle toward x, elevation angle toward z.
  glm::vec3 beam(int j, int k) const;
  // contains: whether a world position lies within the sector, at least `margin` mm from its border.
  bool contains(const glm::vec3& world, float margin = 0) const;
};

// phantomSector: the probe of the simulated scan, sampled as finely as voxels of that spacing can show.
SectorGrid phantomSector(const glm::dvec3& voxelSpacing);

// scanConvert: the values of a sector on a Cartesian grid, trilinear in range and angles.
//   values   sector.samples() of them
//   geometry axes along the world's
//   output   0 outside the sector
//   errors   Cancelled
Volume<float> scanConvert(const SectorGrid& sector, const std::vector<float>& values,
                          const Geometry& geometry, const Progress& progress = {});

}  // namespace sonoskin
