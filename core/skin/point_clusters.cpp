#include "core/skin/point_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/search/point_grid.h"

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr float kFacing = 0.9f;  // cosine of normals of one cluster to its chosen point's

// Chooses points and gives every point the nearest chosen one, in one pass: a point that no earlier choice has reached
// is the next choice. Returns their number.
std::uint32_t assign(const AreaPoints& points, float distance, std::vector<std::uint32_t>& clusterOf,
                     const Progress& progress) {
  const PointGrid grid(points.positions, 2 * distance);
  const std::vector<std::uint32_t>& order = grid.order();
  std::vector<float> nearest(points.size(), std::numeric_limits<float>::max());
  clusterOf.assign(points.size(), kNone);
  std::uint32_t chosen = 0;
  for (std::size_t s = 0; s < order.size(); ++s) {
    if (s % 4096 == 0) progress.update(double(s) / double(order.size()));
    const std::uint32_t seed = order[s];
    if (clusterOf[seed] != kNone) continue;
    const glm::vec3 &centre = points.positions[seed], &normal = points.normals[seed];
    grid.forEachRun(centre, distance, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t p = order[i];
        const glm::vec3 d = points.positions[p] - centre;
        const float squared = glm::dot(d, d);
        if (squared >= std::min(distance * distance, nearest[p])) continue;
        if (glm::dot(points.normals[p], normal) < kFacing) continue;
        nearest[p] = squared;
        clusterOf[p] = chosen;
      }
    });
    clusterOf[seed] = chosen++;
    nearest[seed] = 0;
  }
  return chosen;
}

struct Moments {
  glm::dvec3 position{0}, normal{0};
  double area = 0;
};

}  // namespace

PointClusters clusterPoints(const AreaPoints& points, double distance, const Progress& progress) {
  PointClusters clusters;
  std::vector<Moments> moments(assign(points, float(distance), clusters.clusterOf, progress));
  for (std::size_t p = 0; p < points.size(); ++p) {
    Moments& m = moments[clusters.clusterOf[p]];
    const double area = double(points.areas[p]);
    m.position += area * glm::dvec3(points.positions[p]);
    m.normal += area * glm::dvec3(points.normals[p]);
    m.area += area;
  }
  for (const Moments& m : moments) {
    clusters.points.positions.emplace_back(m.position / m.area);
    clusters.points.normals.emplace_back(m.normal / std::max(glm::length(m.normal), 1e-12));
    clusters.points.areas.push_back(float(m.area));
  }
  double squares = 0, area = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::vec3 d = points.positions[p] - clusters.points.positions[clusters.clusterOf[p]];
    squares += double(points.areas[p]) * double(glm::dot(d, d));
    area += double(points.areas[p]);
  }
  clusters.variance = area > 0 ? 0.5 * squares / area : 0;
  return clusters;
}

}  // namespace sonoskin
