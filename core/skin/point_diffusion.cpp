#include "core/skin/point_diffusion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/skin/diffusion_target.h"

namespace sonoskin {
namespace {

using Link = SparseRows::Link;

constexpr double kWidths = 2.6;          // Gaussians are cut off there
constexpr double kSpacingOfLevel = 0.8;  // widths between a level's points, mean
constexpr double kSpacingOfChoice =
    1.1;  // mean spacing of bunches, over the least distance of their chosen points
constexpr double kReadingReach = 1.5;  // spacings around a place that is read

// The level that a level takes its light from; 0: the base points. Not the one before but the one before that: every step
// asks anew which points face the same way, and the fewer there are, the nearer it comes to the integral at folds.
int sourceOf(int level) { return std::max(0, level - 2); }

// Mean weights of the samples of each base point.
SparseRows gatherRows(const AreaPoints& samples, const PointClusters& clusters) {
  const std::size_t count = clusters.points.size();
  SparseRows rows;
  rows.start.assign(count + 1, 0);
  for (const std::uint32_t b : clusters.bunch) ++rows.start[b + 1];
  std::partial_sum(rows.start.begin(), rows.start.end(), rows.start.begin());
  std::vector<std::uint32_t> next(rows.start.begin(), rows.start.end() - 1);
  rows.links.resize(samples.size());
  for (std::uint32_t s = 0; s < samples.size(); ++s) {
    const std::uint32_t b = clusters.bunch[s];
    rows.links[next[b]++] = {s, samples.areas[s] / clusters.points.areas[b]};
  }
  return rows;
}

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

void scaleToOne(std::vector<Link>& links, std::size_t first) {
  double sum = 0;
  for (std::size_t i = first; i < links.size(); ++i) sum += double(links[i].weight);
  for (std::size_t i = first; i < links.size(); ++i) links[i].weight = float(double(links[i].weight) / sum);
}

// Calls f(number, squared distance) for the points within `reach` of x that face about the same way as n.
template <class F>
void forEachLocal(const PointGrid& grid, const AreaPoints& points, const glm::vec3& x, const glm::vec3& n,
                  float reach, F&& f) {
  grid.forEachRun(x, reach, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t p = grid.order()[i];
      const glm::vec3 d = points.positions[p] - x;
      const float squared = glm::dot(d, d);
      if (squared < reach * reach && isLocal(n, points.normals[p])) f(p, squared);
    }
  });
}

// The point nearest to x, whichever way it faces.
std::uint32_t nearestPoint(const PointGrid& grid, const AreaPoints& points, const glm::vec3& x, float reach) {
  for (;; reach *= 2) {
    std::uint32_t best = 0;
    float least = reach * reach;
    grid.forEachRun(x, reach, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const glm::vec3 d = points.positions[grid.order()[i]] - x;
        if (glm::dot(d, d) < least) least = glm::dot(d, d), best = grid.order()[i];
      }
    });
    if (least < reach * reach) return best;
  }
}

// Weights that read a linear function exactly from the links' points: with them the row's sum is the value at x of the
// plane that fits best, near points counting more. A little of the plane's slope is held back, so that points on one
// side alone are not continued too far.
void fitPlane(std::vector<Link>& links, std::size_t first, const AreaPoints& points, const glm::vec3& x,
              const glm::vec3& n, float reach) {
  const glm::vec3 side =
      glm::normalize(glm::cross(n, std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
  const glm::vec3 up = glm::cross(n, side);
  const auto place = [&](const Link& link) {
    const glm::vec3 d = (points.positions[link.source] - x) / reach;
    return glm::dvec3(1, double(glm::dot(d, side)), double(glm::dot(d, up)));
  };
  constexpr double kHeldBack = 0.003;
  glm::dmat3 moments(0);
  for (std::size_t i = first; i < links.size(); ++i)
    moments += double(links[i].weight) * glm::outerProduct(place(links[i]), place(links[i]));
  moments[1][1] += kHeldBack * moments[0][0];
  moments[2][2] += kHeldBack * moments[0][0];
  const glm::dvec3 value = glm::inverse(moments)[0];
  for (std::size_t i = first; i < links.size(); ++i)
    links[i].weight = float(double(links[i].weight) * glm::dot(value, place(links[i])));
}

}  // namespace

PointDiffusion::Level PointDiffusion::makeLevel(AreaPoints points) {
  Level level;
  const double area = std::accumulate(points.areas.begin(), points.areas.end(), 0.0);
  level.spacing = std::max(1e-3, std::sqrt(area / double(points.size())));
  level.grid = PointGrid(points.positions, float(2 * level.spacing));
  level.points = std::move(points);
  return level;
}

// Rows that blur the light of one level's points by a Gaussian into the next level's.
SparseRows PointDiffusion::spread(const Level& from, const Level& to, double variance,
                                  const Progress& progress) {
  constexpr double kLeastReach = 1.6;  // spacings
  const bool blurs = variance > 1e-3 * from.spacing * from.spacing;
  const CutGaussian gaussian = blurs ? cutGaussian(variance, kLeastReach * from.spacing) : CutGaussian();
  const auto exponent = float(blurs ? -0.5 / gaussian.variance : 0);
  return makeRows(
      to.points.size(),
      [&](std::size_t row, std::vector<Link>& links) {
        const glm::vec3 &x = to.points.positions[row], &n = to.points.normals[row];
        const std::size_t first = links.size();
        if (blurs)
          forEachLocal(from.grid, from.points, x, n, float(gaussian.reach),
                       [&](std::uint32_t p, float squared) {
                         links.push_back({p, from.points.areas[p] * std::exp(exponent * squared)});
                       });
        if (links.size() == first)
          links.push_back({nearestPoint(from.grid, from.points, x, float(from.spacing)), 1});
        scaleToOne(links, first);
      },
      progress);
}

SparseRows PointDiffusion::rowsTo(int level, std::span<const glm::vec3> positions,
                                  std::span<const glm::vec3> normals, const Progress& progress) const {
  const Level& from = levels_[std::size_t(level - 1)];
  const auto reach = float(kReadingReach * from.spacing);
  return makeRows(
      positions.size(),
      [&](std::size_t row, std::vector<Link>& links) {
        const glm::vec3 &x = positions[row], &n = normals[row];
        const std::size_t first = links.size();
        forEachLocal(from.grid, from.points, x, n, reach, [&](std::uint32_t p, float squared) {
          const float near = 1 - squared / (reach * reach);
          links.push_back({p, near * near});
        });
        if (links.size() == first)
          links.push_back({nearestPoint(from.grid, from.points, x, reach), 1});
        else
          fitPlane(links, first, from.points, x, n, reach);
        scaleToOne(links, first);
      },
      progress);
}

PointDiffusion::Levels PointDiffusion::diffuse(std::span<const glm::vec4> irradiance) const {
  require(irradiance.size() == gather_.links.size(), "Every sample of the surface needs an irradiance.");
  Levels result;
  const std::vector<glm::vec4> base = multiply(gather_, irradiance);
  for (int i = 1; i <= kLevels; ++i) {
    const auto from = std::size_t(sourceOf(i));
    result[std::size_t(i - 1)] =
        multiply(levels_[std::size_t(i - 1)].rows, from == 0 ? base : result[from - 1]);
  }
  return result;
}

std::size_t PointDiffusion::bytes() const {
  std::size_t bytes = gather_.bytes();
  for (const Level& level : levels_)
    bytes += level.rows.bytes() + level.points.size() * (2 * sizeof(glm::vec3) + 2 * sizeof(float));
  return bytes;
}

// mm^2 per axis by which reading between the points of a level blurs, the mean over some places.
double PointDiffusion::readingVariance(int level, const AreaPoints& places) const {
  AreaPoints some;
  const std::size_t step = places.size() / 2000 + 1;
  for (std::size_t i = 0; i < places.size(); i += step) {
    some.positions.push_back(places.positions[i]);
    some.normals.push_back(places.normals[i]);
  }
  const SparseRows rows = rowsTo(level, some.positions, some.normals);
  const AreaPoints& points = levels_[std::size_t(level - 1)].points;
  double sum = 0;
  for (std::size_t row = 0; row < rows.rows(); ++row)
    for (std::uint32_t i = rows.start[row]; i < rows.start[row + 1]; ++i) {
      const glm::vec3 d = points.positions[rows.links[i].source] - some.positions[row];
      sum += 0.5 * double(rows.links[i].weight) * double(glm::dot(d, d));
    }
  return std::max(0.0, sum / double(rows.rows()));
}

PointDiffusion::PointDiffusion(const AreaPoints& samples, const GaussianSum& profile,
                               const Progress& progress) {
  require(samples.size() > 0, "Light can spread on a surface only where it has samples.");
  const PointClusters base = clusterPoints(samples, kBaseSpacing, progress.part(0, 0.2));
  gather_ = gatherRows(samples, base);
  const Level start = makeLevel(base.points);
  std::array<double, kLevels + 1> reached{base.variance};
  for (int i = 1; i <= kLevels; ++i) {
    const Progress part = progress.part(0.2 + 0.16 * (i - 1), 0.2 + 0.16 * i);
    const double variance = profile.variances[std::size_t(i)];
    const double spacing = kSpacingOfLevel * std::sqrt(variance);
    const auto own = std::size_t(i), from = std::size_t(sourceOf(i));
    Level& level = levels_[own - 1];
    level = spacing <= start.spacing
                ? makeLevel(base.points)
                : makeLevel(clusterPoints(base.points, spacing / kSpacingOfChoice, part.part(0, 0.3)).points);
    const double reading = readingVariance(i, base.points);
    resolved_[own - 1] = variance > 0.5 * (base.variance + reading);
    const double blur = std::max(0.0, variance - reading - reached[from]);
    reached[own] = reached[from] + blur;
    level.rows = spread(from == 0 ? start : levels_[from - 1], level, blur, part.part(0.3, 1));
  }
}

}  // namespace sonoskin
