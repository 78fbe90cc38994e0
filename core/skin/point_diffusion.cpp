#include "core/skin/point_diffusion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/base/perpendicular.h"
#include "core/skin/diffusion_target.h"

namespace sonoskin {
namespace {

constexpr double kWidths = 3;          // Gaussians are cut off there
constexpr double kSpacing = 0.5;       // widths between a level's clusters, mean
constexpr double kPlaneSpacing = 0.9;  // widths between clusters from which on a sum is too rough
constexpr double kSpacingOfChoice =
    1.1;  // mean spacing of clusters, over the least distance of their chosen points
constexpr double kLeastVariance = 0.2;  // of a Gaussian that is summed, in squares of the clusters' spacing
constexpr std::size_t kPlacesPerTask = 512;

// A Gaussian that is cut off and then has the variance that was asked for.
struct CutGaussian {
  double variance = 0, reach = 0;
};

CutGaussian cutGaussian(double variance, double leastReach) {
  CutGaussian g{variance, leastReach};
  for (int round = 0; round < 20; ++round) {
    g.reach = std::max(kWidths * std::sqrt(g.variance), leastReach);
    const double q = 0.5 * g.reach * g.reach / g.variance;
    const double kept = q < 50 ? 1 - q / std::expm1(q) : 1;  // of the variance inside the reach
    g.variance = variance / kept;
  }
  return g;
}

// The point nearest to x, whichever way it faces.
std::size_t nearestPoint(const PointGrid& grid, const AreaPoints& points, const glm::vec3& x, float reach) {
  for (;; reach *= 2) {
    std::size_t best = 0;
    float least = reach * reach;
    grid.forEachRun(x, reach, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const glm::vec3 d = points.positions[i] - x;
        if (glm::dot(d, d) < least) least = glm::dot(d, d), best = i;
      }
    });
    if (least < reach * reach) return best;
  }
}

// The plane that fits the light around a place best, near points counting more. A little of its slope is held back, so
// that points on one side alone are not continued too far.
class PlaneFit {
 public:
  PlaneFit(const glm::vec3& x, const glm::vec3& n, float reach) : x_(x), inverseReach_(1 / reach) {
    side_ = perpendicularTo<0, 1>(n, 0.7);
    up_ = glm::cross(n, side_);
  }
  void add(float weight, const glm::vec3& position, const glm::vec4& light) {
    const glm::vec3 d = (position - x_) * inverseReach_;
    const glm::dvec3 place(1, double(glm::dot(d, side_)), double(glm::dot(d, up_)));
    moments_ += double(weight) * glm::outerProduct(place, place);
    for (int axis = 0; axis < 3; ++axis) light_[axis] += double(weight) * place[axis] * glm::dvec4(light);
  }
  bool empty() const { return moments_[0][0] == 0; }
  glm::vec4 value() const {
    constexpr double kHeldBack = 0.003;
    glm::dmat3 moments = moments_;
    moments[1][1] += kHeldBack * moments[0][0];
    moments[2][2] += kHeldBack * moments[0][0];
    const glm::dvec3 row = glm::inverse(moments)[0];
    return glm::vec4(row.x * light_[0] + row.y * light_[1] + row.z * light_[2]);
  }

 private:
  glm::vec3 x_, side_, up_;
  float inverseReach_;
  glm::dmat3 moments_{0};
  std::array<glm::dvec4, 3> light_{};
};

AreaPoints inOrder(const AreaPoints& points, const std::vector<std::uint32_t>& order) {
  AreaPoints sorted;
  sorted.positions.reserve(order.size());
  sorted.normals.reserve(order.size());
  sorted.areas.reserve(order.size());
  for (const std::uint32_t i : order) {
    sorted.positions.push_back(points.positions[i]);
    sorted.normals.push_back(points.normals[i]);
    sorted.areas.push_back(points.areas[i]);
  }
  return sorted;
}

}  // namespace

PointDiffusion::Level PointDiffusion::makeLevel(const PointClusters& clusters, const PointClusters& base,
                                                double variance) const {
  constexpr double kLeastReach = 1.6;  // in spacings
  Level level;
  const double area = std::accumulate(areas_.begin(), areas_.end(), 0.0);
  const double spacing = std::max(1e-3, std::sqrt(area / double(clusters.points.size())));
  const double blurred = base.variance + clusters.variance, least = kLeastVariance * spacing * spacing;
  const CutGaussian gaussian = cutGaussian(std::max(variance - blurred, least), kLeastReach * spacing);
  level.resolved = variance > 0.5 * (blurred + least);
  if (!level.resolved) return level;
  level.readsPlane = spacing > kPlaneSpacing * std::sqrt(gaussian.variance);
  level.reach = float(gaussian.reach);
  level.exponent = float(-0.5 / gaussian.variance);
  level.grid = PointGrid(clusters.points.positions, 0.5f * level.reach);
  level.points = inOrder(clusters.points, level.grid.order());
  std::vector<std::uint32_t> place(level.points.size());
  for (std::uint32_t i = 0; i < place.size(); ++i) place[level.grid.order()[i]] = i;
  level.clusterOf.reserve(base.clusterOf.size());
  for (const std::uint32_t b : base.clusterOf)
    level.clusterOf.push_back(place[clusters.clusterOf.empty() ? b : clusters.clusterOf[b]]);
  return level;
}

PointDiffusion::PointDiffusion(const AreaPoints& samples, const GaussianSum& profile,
                               const Progress& progress)
    : areas_(samples.areas) {
  require(samples.size() > 0, "Light can spread on a surface only where it has samples.");
  const PointClusters base = clusterPoints(samples, kBaseSpacing, progress.part(0, 0.3));
  const double area = std::accumulate(areas_.begin(), areas_.end(), 0.0),
               apart = area / double(base.points.size());
  for (int i = 1; i <= kLevels; ++i) {
    const double variance = profile.variances[std::size_t(i)], spacing = kSpacing * std::sqrt(variance);
    // Bunches lie farther apart than the points: a Gaussian that these do not resolve needs none.
    if (variance <= 0.5 * (base.variance + kLeastVariance * apart)) continue;
    const Progress part = progress.part(0.3 + 0.14 * (i - 1), 0.3 + 0.14 * i);
    const PointClusters clusters = spacing <= kBaseSpacing * kSpacingOfChoice
                                       ? PointClusters{base.points, {}, 0}
                                       : clusterPoints(base.points, spacing / kSpacingOfChoice, part);
    levels_[std::size_t(i - 1)] = makeLevel(clusters, base, variance);
    part.update(1);
  }
}

double PointDiffusion::meanNeighbours(int number) const {
  constexpr std::size_t kLooks = 1000;
  const Level& level = levels_[std::size_t(number - 1)];
  const std::size_t step = 1 + level.points.size() / kLooks;
  double found = 0, looks = 0;
  for (std::size_t i = 0; i < level.points.size(); i += step, ++looks)
    level.grid.forEachRun(level.points.positions[i], level.reach,
                          [&](std::size_t first, std::size_t last) { found += double(last - first); });
  return looks > 0 ? found / looks : 0;
}

PointDiffusion::Levels PointDiffusion::gather(std::span<const glm::vec4> irradiance) const {
  Levels result;
  parallelFor(kLevels, [&](std::ptrdiff_t l) { result[std::size_t(l)] = gather(int(l) + 1, irradiance); });
  return result;
}

std::vector<glm::vec4> PointDiffusion::gather(int number, std::span<const glm::vec4> irradiance) const {
  require(irradiance.size() == areas_.size(), "Every sample of the surface needs an irradiance.");
  const Level& level = levels_[std::size_t(number - 1)];
  std::vector<glm::vec4> light(level.points.size(), glm::vec4(0));
  for (std::size_t s = 0; s < irradiance.size(); ++s)
    light[level.clusterOf[s]] += areas_[s] / level.points.areas[level.clusterOf[s]] * irradiance[s];
  return light;
}

std::vector<glm::vec4> PointDiffusion::lightAt(int number, std::span<const glm::vec4> gathered,
                                               std::span<const glm::vec3> positions,
                                               std::span<const glm::vec3> normals,
                                               const Progress& progress) const {
  const Level& level = levels_[std::size_t(number - 1)];
  const AreaPoints& points = level.points;
  // Calls f(weight, point) for the clusters around a place that face about the same way.
  const auto forEachLocal = [&](const glm::vec3& x, const glm::vec3& n, auto&& f) {
    level.grid.forEachRun(x, level.reach, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const glm::vec3 d = points.positions[i] - x;
        const float squared = glm::dot(d, d);
        if (squared < level.reach * level.reach && isLocal(n, points.normals[i]))
          f(points.areas[i] * std::exp(level.exponent * squared), i);
      }
    });
  };
  const auto lightOf = [&](const glm::vec3& x, const glm::vec3& n) {
    if (level.readsPlane) {
      PlaneFit plane(x, n, level.reach);
      forEachLocal(x, n, [&](float w, std::size_t i) { plane.add(w, points.positions[i], gathered[i]); });
      if (!plane.empty()) return plane.value();
    } else {
      glm::vec4 light(0);
      float weights = 0;
      forEachLocal(x, n, [&](float w, std::size_t i) { light += w * gathered[i], weights += w; });
      if (weights > 0) return light / weights;
    }
    return gathered[nearestPoint(level.grid, points, x, level.reach)];
  };
  std::vector<glm::vec4> light(positions.size());
  parallelItems(
      positions.size(), kPlacesPerTask, [&](std::size_t p) { light[p] = lightOf(positions[p], normals[p]); },
      progress);
  return light;
}

std::size_t PointDiffusion::bytes() const {
  std::size_t bytes = areas_.size() * sizeof(float);
  for (const Level& level : levels_)
    bytes += level.clusterOf.size() * sizeof(std::uint32_t) +
             level.points.size() * (2 * sizeof(glm::vec3) + sizeof(float) + sizeof(std::uint32_t));
  return bytes;
}

}  // namespace sonoskin
