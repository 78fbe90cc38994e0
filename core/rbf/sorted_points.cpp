#include "core/rbf/sorted_points.h"

#include <cmath>

#include "core/base/error.h"
#include "core/rbf/influences.h"

namespace sonoskin {
namespace {

constexpr double kCellsPerSpacing = 2.2;

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool lieOnOneLine(const std::vector<glm::vec3>& positions, float diagonal) {
  const glm::vec3 start = positions.front();
  glm::vec3 farthest = start;
  for (const glm::vec3& p : positions)
    if (glm::distance(p, start) > glm::distance(farthest, start)) farthest = p;
  if (farthest == start) return true;
  const glm::vec3 along = glm::normalize(farthest - start);
  for (const glm::vec3& p : positions)
    if (glm::length(glm::cross(p - start, along)) > 1e-5f * diagonal) return false;
  return true;
}

}  // namespace

void checkPoints(const SurfacePoints& points) {
  require(points.size() >= kMinPointsInSupport,
          "Only {} surface points were found, but a surface needs at least {}; lower the surface threshold.",
          points.size(), kMinPointsInSupport);
  require(points.normals.size() == points.size() && points.confidence.size() == points.size(),
          "The surface points are incomplete: {} positions, {} normals, {} confidences.", points.size(),
          points.normals.size(), points.confidence.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(isFinite(points.positions[i]), "Surface point {} has a coordinate that is not a finite number.",
            i);
    require(isFinite(points.normals[i]) && glm::length(points.normals[i]) > 1e-6f,
            "Surface point {} has no normal; smooth the volume more before finding surfaces.", i);
    require(std::isfinite(points.confidence[i]) && points.confidence[i] > 0,
            "Surface point {} has the confidence {}, but it must be above 0.", i, points.confidence[i]);
  }
  require(!lieOnOneLine(points.positions, boundingBox(points.positions).diagonal()),
          "All {} surface points lie on one line, which spans no surface; lower the surface threshold.",
          points.size());
}

namespace {

void copySorted(const SurfacePoints& points, SortedPoints& sorted) {
  const std::size_t count = points.size();
  for (auto* array : {&sorted.x, &sorted.y, &sorted.z, &sorted.nx, &sorted.ny, &sorted.nz})
    array->resize(count);
  for (std::size_t s = 0; s < count; ++s) {
    const std::uint32_t i = sorted.grid.order()[s];
    const glm::vec3 p = points.positions[i], n = glm::normalize(points.normals[i]);
    sorted.x[s] = p.x, sorted.y[s] = p.y, sorted.z[s] = p.z;
    sorted.nx[s] = n.x, sorted.ny[s] = n.y, sorted.nz[s] = n.z;
  }
}

}  // namespace

SortedPoints sortPoints(const SurfacePoints& points, const ReconstructionOptions& options,
                        const Progress& progress) {
  checkPoints(points);
  SortedPoints sorted;
  sorted.spacing = pointSpacing(points.positions);
  progress.update(0.1);
  sorted.grid = PointGrid(points.positions, float(kCellsPerSpacing * sorted.spacing));
  sorted.diagonal = double(sorted.grid.box().diagonal());
  copySorted(points, sorted);
  progress.update(0.2);

  if (options.measuredNoise && !points.noise.empty()) {
    sorted.noise.reserve(points.size());
    for (const std::uint32_t i : sorted.grid.order()) sorted.noise.push_back(points.noise[i]);
  }
  // Without confidence every point counts the same.
  std::vector<float> confidence(points.size(), 1.f);
  if (options.confidence)
    for (std::size_t s = 0; s < points.size(); ++s) confidence[s] = points.confidence[sorted.grid.order()[s]];
  sorted.influence = influences(sorted, confidence, options.neighbours, progress.part(0.2, 1));
  return sorted;
}

}  // namespace sonoskin
