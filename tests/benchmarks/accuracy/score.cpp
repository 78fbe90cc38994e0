#include "tests/benchmarks/accuracy/score.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "tests/benchmarks/accuracy/point_tree.h"

namespace sonoskin::accuracy {
namespace {

constexpr float kRegion = 5;  // voxels from the visible skin within which points tell of a method's offset
constexpr std::ptrdiff_t kBatch = 256;

template <class Body>
void forEachPoint(std::size_t count, const Body& body) {
  const auto total = std::ptrdiff_t(count);
  parallelFor((total + kBatch - 1) / kBatch, [&](std::ptrdiff_t batch) {
    for (std::ptrdiff_t n = batch * kBatch; n < std::min(total, (batch + 1) * kBatch); ++n)
      body(std::size_t(n));
  });
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The medians of the signed distances to the skin, in units of `unit` mm, of the points near its visible part.
double medianOffset(const SurfacePoints& points, const Truth& truth, const std::vector<char>& inRegion,
                    const glm::dvec3& unit) {
  std::vector<double> distance(points.size(), kFar), kept;
  forEachPoint(points.size(), [&](std::size_t p) {
    if (inRegion[p]) distance[p] = truth.toSkin(glm::dvec3(points.positions[p]), unit);
  });
  for (const double d : distance)
    if (std::abs(d) < kFar) kept.push_back(d);
  return median(std::move(kept));
}

std::vector<glm::vec3> indicesOf(const std::vector<glm::vec3>& positions, const Geometry& geometry) {
  std::vector<glm::vec3> indices;
  indices.reserve(positions.size());
  for (const glm::vec3& p : positions) indices.emplace_back(geometry.toIndex(glm::dvec3(p)));
  return indices;
}

struct FoundAt {
  Found near, far;  // 1.5 and 3 voxels
};

FoundAt countFound(const std::vector<glm::vec3>& positions, const Truth& truth) {
  std::vector<double> toTruth(positions.size()), toPoint(truth.visible().size());
  forEachPoint(positions.size(),
               [&](std::size_t p) { toTruth[p] = truth.toFluidSurface(glm::dvec3(positions[p])); });
  const std::vector<glm::vec3> indices = indicesOf(positions, truth.geometry());
  const PointTree tree(indices);
  forEachPoint(toPoint.size(),
               [&](std::size_t v) { toPoint[v] = double(tree.distance(truth.visible()[v])); });
  const auto share = [](const std::vector<double>& distances, double radius) {
    const auto within = [&](double d) { return d <= radius; };
    return distances.empty()
               ? 0.0
               : double(std::count_if(distances.begin(), distances.end(), within)) / double(distances.size());
  };
  return {{share(toTruth, 1.5), share(toPoint, 1.5)}, {share(toTruth, 3), share(toPoint, 3)}};
}

double residualOf(const std::vector<glm::vec3>& positions, const Truth& truth) {
  constexpr double kMatched = 3;
  std::vector<double> distance(positions.size(), kFar);
  const std::vector<glm::vec3> indices = indicesOf(positions, truth.geometry());
  forEachPoint(positions.size(), [&](std::size_t p) {
    if (truth.nearVisible(indices[p], kRegion))
      distance[p] = truth.toSkin(glm::dvec3(positions[p]), truth.geometry().spacing);
  });
  double squares = 0, matched = 0;
  for (const double d : distance)
    if (std::abs(d) <= kMatched) squares += d * d, ++matched;
  return matched > 0 ? std::sqrt(squares / matched) : 0;
}

}  // namespace

Score scorePoints(const SurfacePoints& points, const Truth& truth) {
  Score score;
  score.points = points.size();
  const std::vector<glm::vec3> indices = indicesOf(points.positions, truth.geometry());
  std::vector<char> inRegion(points.size());
  forEachPoint(points.size(), [&](std::size_t p) { inRegion[p] = truth.nearVisible(indices[p], kRegion); });
  score.offsetVoxels = medianOffset(points, truth, inRegion, truth.geometry().spacing);
  score.offsetMm = medianOffset(points, truth, inRegion, glm::dvec3(1));
  std::vector<glm::vec3> debiased = points.positions;
  for (std::size_t p = 0; p < points.size(); ++p) debiased[p] -= float(score.offsetMm) * points.normals[p];
  const FoundAt raw = countFound(points.positions, truth), moved = countFound(debiased, truth);
  score.raw15 = raw.near, score.raw3 = raw.far;
  score.debiased15 = moved.near, score.debiased3 = moved.far;
  score.residual = residualOf(debiased, truth);
  return score;
}

}  // namespace sonoskin::accuracy
