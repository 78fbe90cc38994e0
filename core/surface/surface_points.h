#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/surface/thinning.h"

namespace sonoskin {

// SurfacePoints: an oriented point cloud on the skin. World mm, LPS.
//   normals      unit, outward: toward the dark side (the fluid, the probe)
//   confidence   > 0, at most 1: the classified value at the point
//   noise        standard deviation of a point's place along its normal, mm; empty where it is not known
// All have the same length.
struct SurfacePoints {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<float> confidence;
  std::vector<float> noise{};

  std::size_t size() const { return positions.size(); }
};

// extractSurfacePoints: the world positions of surface voxels, with normals from the low-passed volume.
//   normals    n = -grad v~ / |grad v~| at the refined position; points where the gradient is zero are left out
//   errors     Cancelled
SurfacePoints extractSurfacePoints(const std::vector<SurfaceVoxel>& voxels, const Volume<float>& lowPassed,
                                   const Progress& progress = {});

// thinnedVolume: u as 1..255 on the surface voxels and 0 elsewhere.
Volume<std::uint8_t> thinnedVolume(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry);

}  // namespace sonoskin
