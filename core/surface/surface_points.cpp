#include "core/surface/surface_points.h"

#include <algorithm>
#include <cmath>

#include "core/volume/sample.h"

namespace sonoskin {
namespace {

// Central differences over one voxel to either side, per mm along i, j, k, at any position.
glm::vec3 gradientBetweenVoxels(const Volume<float>& v, const glm::vec3& position) {
  glm::vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 step(0);
    step[axis] = 1;
    gradient[axis] = (sampleTrilinear(v, position + step) - sampleTrilinear(v, position - step)) /
                     float(2 * v.geometry.spacing[axis]);
  }
  return gradient;
}

}  // namespace

SurfacePoints extractSurfacePoints(const std::vector<SurfaceVoxel>& voxels, const Volume<float>& lowPassed,
                                   const Progress& progress) {
  const Geometry& g = lowPassed.geometry;
  SurfacePoints points;
  points.positions.reserve(voxels.size());
  points.normals.reserve(voxels.size());
  points.confidence.reserve(voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (v % 4096 == 0) progress.update(double(v) / double(voxels.size()));
    const glm::vec3 gradient = gradientBetweenVoxels(lowPassed, voxels[v].position);
    const float length = glm::length(gradient);
    if (!(length > 0)) continue;
    points.positions.emplace_back(g.toWorld(glm::dvec3(voxels[v].position)));
    points.normals.emplace_back(g.toWorldDirection(glm::dvec3(-gradient / length)));
    points.confidence.push_back(std::clamp(voxels[v].value, 1e-3f, 1.0f));
  }
  return points;
}

Volume<std::uint8_t> thinnedVolume(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry) {
  Volume<std::uint8_t> volume(geometry);
  for (const SurfaceVoxel& v : voxels)
    volume.at(v.voxel.x, v.voxel.y, v.voxel.z) =
        std::uint8_t(std::clamp(std::lround(255 * double(v.value)), 1l, 255l));
  return volume;
}

}  // namespace sonoskin
