#include "core/rbf/global/global_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <numeric>
#include <tuple>

#include "core/base/parallel_blocks.h"
#include "core/rbf/sorted_points.h"

namespace sonoskin {
namespace {

constexpr int kHalvings = 6;
constexpr std::size_t kPointsPerTask = 256;

// The sites as nanoflann wants to see them.
struct SiteCloud {
  const Sites& sites;
  std::size_t kdtree_get_point_count() const { return sites.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return sites[i][int(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using SiteTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, SiteCloud>, SiteCloud, 3>;

// The indices of sites that equal no earlier one, ascending.
std::vector<std::uint32_t> distinct(const Sites& sites) {
  std::vector<std::uint32_t> order(sites.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tuple(sites.x[i], sites.y[i], sites.z[i]); };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::tuple(key(a), a) < std::tuple(key(b), b); });
  const auto same = [&](std::uint32_t a, std::uint32_t b) { return key(a) == key(b); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  std::sort(order.begin(), order.end());
  return order;
}

// The distance along `direction` at which site i is still the nearest of the surface; 0: there is none.
double validDistance(const SiteTree& tree, const Sites& surface, std::size_t i, const glm::dvec3& direction,
                     double distance) {
  for (int halving = 0; halving <= kHalvings; ++halving, distance /= 2) {
    const glm::dvec3 p = surface[i] + distance * direction;
    std::uint32_t nearest = 0;
    double squared = 0;
    tree.knnSearch(&p.x, 1, &nearest, &squared);
    if (nearest == i) return distance;
  }
  return 0;
}

// Every how many-th point has points off the surface: evenly through the order of the points.
bool hasOffSurface(std::size_t i, double share) {
  return std::floor(double(i + 1) * share) > std::floor(double(i) * share);
}

// Signed distances, outside and inside, of the points off the surface of each surface point; 0: none.
using Distances = std::vector<std::array<double, 2>>;
Distances offDistances(const Sites& surface, const std::vector<glm::dvec3>& normals,
                       const GlobalOptions& options, const Progress& progress) {
  const SiteCloud cloud{surface};  // the tree refers to it
  const SiteTree tree(3, cloud);
  Distances result(surface.size(), {0, 0});
  parallelItems(
      surface.size(), kPointsPerTask,
      [&](std::size_t i) {
        if (!hasOffSurface(i, options.offsetShare)) return;
        result[i][0] = validDistance(tree, surface, i, normals[i], options.offset);
        result[i][1] = -validDistance(tree, surface, i, -normals[i], options.offset);
      },
      progress);
  return result;
}

void keepDistinct(GlobalPoints& points) {
  const std::vector<std::uint32_t> kept = distinct(points.sites);
  std::vector<double> values;
  for (const std::uint32_t i : kept) values.push_back(points.values[i]);
  points.sites = pick(points.sites, kept);
  points.values = std::move(values);
}

}  // namespace

GlobalPoints makeGlobalPoints(const SurfacePoints& points, const GlobalOptions& options,
                              const Progress& progress) {
  checkPoints(points);
  Sites all;
  for (const glm::vec3& p : points.positions) all.push_back(glm::dvec3(p));
  const std::vector<std::uint32_t> kept = distinct(all);
  GlobalPoints result;
  result.sites = pick(all, kept);
  result.onSurface = kept.size();
  result.values.assign(kept.size(), 0);
  std::vector<glm::dvec3> normals;
  for (const std::uint32_t i : kept) normals.push_back(glm::normalize(glm::dvec3(points.normals[i])));

  const Sites surface = result.sites;
  const Distances distances = offDistances(surface, normals, options, progress);
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (const double d : distances[i])
      if (d != 0) {
        result.sites.push_back(surface[i] + d * normals[i]);
        result.values.push_back(d);
      }
  keepDistinct(result);
  return result;
}

}  // namespace sonoskin
