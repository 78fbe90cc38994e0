#include "core/surface/surface_points.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel_blocks.h"
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

constexpr std::size_t kBlock = 1024;  // voxels that one thread takes at a time

void addPoint(const SurfaceVoxel& voxel, const Volume<float>& lowPassed, SurfacePoints& block) {
  const Geometry& g = lowPassed.geometry;
  const glm::vec3 gradient = gradientBetweenVoxels(lowPassed, voxel.position);
  const float length = glm::length(gradient);
  if (!(length > 0)) return;
  block.positions.emplace_back(g.toWorld(glm::dvec3(voxel.position)));
  block.normals.emplace_back(g.toWorldDirection(glm::dvec3(-gradient / length)));
  block.confidence.push_back(std::clamp(voxel.value, 1e-3f, 1.0f));
}

}  // namespace

SurfacePoints extractSurfacePoints(const std::vector<SurfaceVoxel>& voxels, const Volume<float>& lowPassed,
                                   const Progress& progress) {
  std::vector<SurfacePoints> blocks(blockCount(voxels.size(), kBlock));
  parallelItems(
      voxels.size(), kBlock, [&](std::size_t v) { addPoint(voxels[v], lowPassed, blocks[v / kBlock]); },
      progress);
  SurfacePoints points;
  points.positions.reserve(voxels.size());
  points.normals.reserve(voxels.size());
  points.confidence.reserve(voxels.size());
  for (const SurfacePoints& block : blocks) {
    points.positions.insert(points.positions.end(), block.positions.begin(), block.positions.end());
    points.normals.insert(points.normals.end(), block.normals.begin(), block.normals.end());
    points.confidence.insert(points.confidence.end(), block.confidence.begin(), block.confidence.end());
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
