#include "core/skin/point_diffusion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

constexpr double kWidths = 3;          // Gaussians are cut off there
constexpr double kSpacing = 0.5;       // widths between a level's clusters, mean
constexpr double kPlaneSpacing = 0.9;  // widths between clusters from which on a sum is too rough
constexpr double kSpacingOfChoice =
    1.1;  // mean spacing of clusters, over the least distance of their chosen points
constexpr double kLeastVariance = 0.2;  // of a Gaussian that is summed, in squares of the clusters' spacing
constexpr std::size_t kPlacesPerTask = 512;
constexpr float kWidestEight = 0.7f;  // reaches: places that are asked together

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

// How many places from `first` on, eight at most, lie within a box with no side longer than `widest`.
std::size_t togetherFrom(const DiffusionPlaces& places, std::size_t first, std::size_t end, float widest) {
  glm::vec3 low = places.positions[first], high = low;
  std::size_t count = 1;
  for (; count < ClusterSum::kLanes && first + count < end; ++count) {
    low = glm::min(low, places.positions[first + count]);
    high = glm::max(high, places.positions[first + count]);
    const glm::vec3 side = high - low;
    if (std::max({side.x, side.y, side.z}) > widest) break;
  }
  return count;
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
  const bool readsPlane = spacing > kPlaneSpacing * std::sqrt(gaussian.variance);
  level.clusters = ClusterSum(clusters.points, gaussian.reach, gaussian.variance, readsPlane);
  std::vector<std::uint32_t> place(level.clusters.size());
  for (std::uint32_t i = 0; i < place.size(); ++i) place[level.clusters.order()[i]] = i;
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
  const int last = smoothLevel(profile) == kSmooth ? kSmooth : kLevels;
  for (int i = 1; i <= last; ++i) {
    const double variance = varianceOf(profile, i), spacing = kSpacing * std::sqrt(variance);
    // Bunches lie farther apart than the points: a Gaussian that these do not resolve needs none.
    if (variance <= 0.5 * (base.variance + kLeastVariance * apart)) continue;
    const Progress part = progress.part(0.3 + 0.11 * (i - 1), 0.3 + 0.11 * i);
    const PointClusters clusters = spacing <= kBaseSpacing * kSpacingOfChoice
                                       ? PointClusters{base.points, {}, 0}
                                       : clusterPoints(base.points, spacing / kSpacingOfChoice, part);
    levels_[std::size_t(i - 1)] = makeLevel(clusters, base, variance);
    part.update(1);
  }
}

int PointDiffusion::smoothLevel(const GaussianSum& profile) {
  for (int i = 1; i <= kLevels; ++i)
    if (std::abs(profile.variances[std::size_t(i)] / kSmoothVariance - 1) < 0.03) return i;
  return kSmooth;
}

double PointDiffusion::varianceOf(const GaussianSum& profile, int level) {
  return level == kSmooth ? kSmoothVariance : profile.variances[std::size_t(level)];
}

double PointDiffusion::meanNeighbours(int number) const {
  constexpr std::size_t kLooks = 1000;
  const Level& level = levels_[std::size_t(number - 1)];
  const std::size_t step = 1 + level.clusters.size() / kLooks;
  double found = 0, looks = 0;
  for (std::size_t i = 0; i < level.clusters.size(); i += step, ++looks)
    found += double(level.clusters.neighbours(i));
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
  std::vector<glm::vec4> light(level.clusters.size(), glm::vec4(0));
  for (std::size_t s = 0; s < irradiance.size(); ++s)
    light[level.clusterOf[s]] += areas_[s] / level.clusters.area(level.clusterOf[s]) * irradiance[s];
  return light;
}

void PointDiffusion::addLightAt(int number, std::span<const glm::vec4> gathered,
                                const DiffusionPlaces& places, const glm::vec4& weight,
                                std::span<glm::vec4> sum, const Progress& progress) const {
  const ClusterSum& clusters = levels_[std::size_t(number - 1)].clusters;
  const float widest = kWidestEight * clusters.reach();
  parallelBlocks(
      places.size(), kPlacesPerTask,
      [&](std::size_t first, std::size_t end) {
        std::array<glm::vec4, ClusterSum::kLanes> means;
        while (first < end) {
          const std::size_t count = togetherFrom(places, first, end, widest);
          clusters.meansAt(std::span(places.positions).subspan(first, count),
                           std::span(places.normals).subspan(first, count), gathered, means.data());
          for (std::size_t i = 0; i < count; ++i) sum[places.order[first + i]] += weight * means[i];
          first += count;
        }
      },
      progress);
}

std::vector<glm::vec4> PointDiffusion::lightAt(int number, std::span<const glm::vec4> gathered,
                                               const DiffusionPlaces& places) const {
  std::vector<glm::vec4> light(places.size(), glm::vec4(0));
  addLightAt(number, gathered, places, glm::vec4(1), light);
  return light;
}

std::size_t PointDiffusion::bytes() const {
  std::size_t bytes = areas_.size() * sizeof(float);
  for (const Level& level : levels_)
    bytes += level.clusterOf.size() * sizeof(std::uint32_t) + level.clusters.bytes();
  return bytes;
}

}  // namespace sonoskin
