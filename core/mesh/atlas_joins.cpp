#include "core/mesh/atlas_joins.h"

#include <cmath>
#include <unordered_map>

#include "core/mesh/atlas_regions.h"
#include "core/mesh/raster.h"

namespace sonoskin {
namespace {

constexpr double kTurned = 0.08;  // largest share of a chart that may be turned away from its axis
constexpr float kCell = 0.6f, kDepth = 0.8f;  // mm

// ChartCells: how deep the surface lies in each cell of each chart.
class ChartCells {
 public:
  ChartCells(const Facets& facets, const std::array<ChartAxis, kChartAxes>& axes)
      : facets_(facets), axes_(axes) {
    const Box box = boundingBox(facets.mesh.positions);
    centre_ = box.centre();
    cell_ = std::max(kCell, box.diagonal() / float(kSide - 2));
  }

  void add(std::uint32_t chart, std::uint32_t axis, const std::vector<std::uint32_t>& triangles) {
    forEachCell(axis, triangles, [&](std::uint64_t cell, float depth) {
      cells_.try_emplace(key(chart, cell), depth);
      return true;
    });
  }
  // The share of the cells of some triangles where they lie over or under the chart or each other.
  double conflict(std::uint32_t chart, std::uint32_t axis,
                  const std::vector<std::uint32_t>& triangles) const {
    std::unordered_map<std::uint64_t, float> own;
    std::size_t cells = 0, conflicts = 0;
    forEachCell(axis, triangles, [&](std::uint64_t cell, float depth) {
      ++cells;
      const auto mine = own.try_emplace(cell, depth).first;
      const auto there = cells_.find(key(chart, cell));
      const bool overOther = there != cells_.end() && std::abs(there->second - depth) > kDepth;
      conflicts += overOther || std::abs(mine->second - depth) > kDepth;
    });
    return cells > 0 ? double(conflicts) / double(cells) : 0;
  }

 private:
  static constexpr int kSide = 1 << 13;  // cells along each side of the space
  static std::uint64_t key(std::uint32_t chart, std::uint64_t cell) {
    return std::uint64_t(chart) << 40 | cell;
  }

  template <class F>
  void forEachCell(std::uint32_t axis, const std::vector<std::uint32_t>& triangles, const F& f) const {
    for (const std::uint32_t t : triangles) {
      std::array<glm::vec3, 3> p;
      std::array<glm::vec2, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = axes_[axis].project(facets_.mesh.positions[facets_.mesh.triangles[t][i]] - centre_);
        corners[i] = glm::vec2(p[i]) / cell_ + 0.5f * kSide;
      }
      forEachTexel(corners, kSide, {0, kSide}, [&](int x, int y, const glm::vec3& w) {
        f(std::uint64_t(y) << 20 | std::uint64_t(x), w.x * p[0].z + w.y * p[1].z + w.z * p[2].z);
      });
    }
  }

  const Facets& facets_;
  const std::array<ChartAxis, kChartAxes>& axes_;
  glm::vec3 centre_{0};
  float cell_ = kCell;
  std::unordered_map<std::uint64_t, float> cells_;
};

// The share of some triangles' area that is turned away from an axis.
double turnedAway(const Facets& facets, const std::vector<glm::vec3>& normals,
                  const std::vector<std::uint32_t>& triangles, const glm::vec3& toward) {
  double away = 0, all = 0;
  for (const std::uint32_t t : triangles) {
    const auto area = double(facets.area(t));
    all += area;
    if (glm::dot(normals[t], toward) < kLeastFacing) away += area;
  }
  return all > 0 ? away / all : 0;
}

// The neighbours of a region, those with the longest borders first.
std::vector<std::uint32_t> neighboursOf(const Region& region) {
  std::vector<std::pair<double, std::uint32_t>> byBorder;
  for (const auto& [other, length] : region.borders) byBorder.emplace_back(-length, other);
  std::sort(byBorder.begin(), byBorder.end());
  std::vector<std::uint32_t> neighbours;
  for (const auto& [length, other] : byBorder) neighbours.push_back(other);
  return neighbours;
}

}  // namespace

void joinCharts(const Facets& facets, const std::vector<glm::vec3>& normals,
                const std::array<ChartAxis, kChartAxes>& axes, JoinLimits limits, Charts& charts) {
  ChartRegions regions(facets, charts);
  std::vector<std::vector<std::uint32_t>> triangles(charts.size());
  for (std::uint32_t t = 0; t < facets.size(); ++t) triangles[charts.ofTriangle[t]].push_back(t);
  ChartCells cells(facets, axes);
  std::vector<std::pair<double, std::uint32_t>> small;
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    cells.add(c, charts.axis[c], triangles[c]);
    if (regions[c].area < limits.smallest) small.emplace_back(regions[c].area, c);
  }
  std::sort(small.begin(), small.end());
  for (const auto& [area, c] : small)
    for (const std::uint32_t into : neighboursOf(regions[c])) {
      const std::uint32_t axis = charts.axis[into];
      if (turnedAway(facets, normals, triangles[c], axes[axis].toward) > std::min(limits.share, kTurned))
        continue;
      const double conflict = cells.conflict(into, axis, triangles[c]);
      if (conflict > limits.share || conflict * area > limits.hidden) continue;
      limits.hidden -= conflict * area;
      cells.add(into, axis, triangles[c]);
      triangles[into].insert(triangles[into].end(), triangles[c].begin(), triangles[c].end());
      triangles[c].clear();
      regions.merge(c, into);
      break;
    }
  regions.apply(charts);
}

}  // namespace sonoskin
