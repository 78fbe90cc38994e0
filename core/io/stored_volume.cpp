#include "core/io/stored_volume.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kMaxVoxels = std::uint64_t(1) << 31;

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Gram-Schmidt, for axes that are at right angles within what a header's decimals can say.
void orthonormalise(Geometry& g, const fs::path& path) {
  constexpr double kTolerance = 1e-3;
  const glm::dmat3 error = glm::transpose(g.direction) * g.direction - glm::dmat3(1);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      require(std::abs(error[c][r]) < kTolerance,
              "The axes in {} are not at right angles; resample the volume to a straight grid first.",
              path.string());
  glm::dvec3 &x = g.direction[0], &y = g.direction[1], &z = g.direction[2];
  x = glm::normalize(x);
  y = glm::normalize(y - glm::dot(x, y) * x);
  z = glm::cross(x, y) * (glm::dot(glm::cross(x, y), z) < 0 ? -1.0 : 1.0);
}

void checkDims(const glm::ivec3& dims, const fs::path& path) {
  for (int a = 0; a < 3; ++a) {
    require(dims[a] != 1, "{} is a flat picture of {} x {} x {}; choose a volume, or the whole series.",
            path.string(), dims.x, dims.y, dims.z);
    require(dims[a] >= 2 && dims[a] <= 65535,
            "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(), dims[a]);
  }
  const std::uint64_t voxels = std::uint64_t(dims.x) * std::uint64_t(dims.y) * std::uint64_t(dims.z);
  require(voxels <= kMaxVoxels,
          "{} says that it has {} x {} x {} voxels, more than fit into memory; crop it first.", path.string(),
          dims.x, dims.y, dims.z);
}

// mm: a grain of dust and a room, so that lengths in metres and micrometres taken for millimetres are told; places
// farther away than that lose hundredths of a millimetre in a float.
constexpr double kLeastExtent = 0.05, kMostExtent = 10'000, kFarthestOrigin = 100'000;
constexpr double kMostAnisotropic = 1000;  // largest spacing beside the smallest

}  // namespace

void checkTime(int time, int timeSteps, const fs::path& path) {
  require(time >= 1 && time <= timeSteps, "{} has {} time step{}; there is no step {} (scan.time).",
          path.string(), timeSteps, timeSteps == 1 ? "" : "s", time);
}

void checkGeometry(StoredVolume& stored, const fs::path& path) {
  Geometry& g = stored.geometry;
  checkDims(g.dims, path);
  require(finite(g.spacing) && g.spacing.x > 0 && g.spacing.y > 0 && g.spacing.z > 0,
          "The spacing in {} is {} x {} x {}; it must be positive, correct the header.", path.string(),
          g.spacing.x, g.spacing.y, g.spacing.z);
  const glm::dvec3 extent = glm::dvec3(g.dims) * g.spacing;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double coarsest = std::max({g.spacing.x, g.spacing.y, g.spacing.z});
  require(
      longest >= kLeastExtent && longest <= kMostExtent && coarsest <= kMostAnisotropic * g.minSpacing(),
      "The spacing in {} is {} x {} x {} mm, which no scan of a body has; correct the unit in the header.",
      path.string(), g.spacing.x, g.spacing.y, g.spacing.z);
  require(finite(g.origin) && glm::length(g.origin) <= kFarthestOrigin,
          "The origin in {} is no position within 100 m; correct the header.", path.string());
  for (int a = 0; a < 3; ++a)
    require(finite(g.direction[a]), "The direction of the axes in {} is not finite; correct the header.",
            path.string());
  orthonormalise(g, path);
  require(stored.timeSteps >= 1 && stored.components >= 1, "{} says that it has no voxels; get a fresh copy.",
          path.string());
  require(stored.components == 1 || stored.components == 3 || stored.components == 4,
          "{} has {} numbers per voxel; a volume has one, or three or four of colour.", path.string(),
          stored.components);
}

}  // namespace sonoskin
