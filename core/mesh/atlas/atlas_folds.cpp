#include "core/mesh/atlas/atlas_folds.h"

#include <limits>

#include "core/mesh/atlas/raster.h"

namespace sonoskin {
namespace {

// mm of a body: those of larger and smaller objects are as many units.
constexpr float kCell = 0.3f, kDepth = 0.8f;  // [theory/skin.md, 3.2, step 5]
constexpr float kMargin = 1;                  // around what is hidden

using Projected = std::array<glm::vec3, 3>;

Projected project(const Facets& facets, std::uint32_t t, const ChartAxis& axis) {
  Projected p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = axis.project(facets.mesh.positions[facets.mesh.triangles[t][i]]);
  return p;
}

// DepthPicture: how near the nearest point of a chart is to the one who looks, per cell.
struct DepthPicture {
  glm::vec2 origin{0};
  float cell = kCell;
  glm::ivec2 size{1};
  std::vector<float> nearest;

  DepthPicture(const glm::vec2& low, const glm::vec2& high, float unit) : origin(low) {
    constexpr float kMostCells = 1 << 24;
    const glm::vec2 extent = high - low;
    cell = std::max(kCell * unit, std::sqrt(extent.x * extent.y / kMostCells));
    size = glm::min(glm::ivec2(extent / cell) + 1, glm::ivec2(1 << 24));
    nearest.assign(std::size_t(size.x) * std::size_t(size.y), -std::numeric_limits<float>::max());
  }
  // f(cell's value, depth of the triangle there)
  template <class F>
  void forEach(const Projected& p, const F& f) {
    std::array<glm::vec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = (glm::vec2(p[i]) - origin) / cell;
    forEachTexel(corners, size.x, {0, size.y}, [&](int x, int y, const glm::vec3& w) {
      f(nearest[std::size_t(y) * std::size_t(size.x) + std::size_t(x)],
        w.x * p[0].z + w.y * p[1].z + w.z * p[2].z);
    });
  }
};

void markHidden(const Facets& facets, const std::uint32_t* begin, const std::uint32_t* end,
                const ChartAxis& axis, float unit, std::vector<std::uint8_t>& isHidden) {
  glm::vec2 low(std::numeric_limits<float>::max()), high = -low;
  for (const std::uint32_t* t = begin; t != end; ++t)
    for (const glm::vec3& p : project(facets, *t, axis)) {
      low = glm::min(low, glm::vec2(p));
      high = glm::max(high, glm::vec2(p));
    }
  DepthPicture picture(low, high, unit);
  for (const std::uint32_t* t = begin; t != end; ++t)
    picture.forEach(project(facets, *t, axis),
                    [](float& nearest, float z) { nearest = std::max(nearest, z); });
  for (const std::uint32_t* t = begin; t != end; ++t)
    picture.forEach(project(facets, *t, axis), [&](float& nearest, float z) {
      if (nearest - z > kDepth * unit) isHidden[*t] = 1;
    });
}

// Marks what lies within `margin` mm of what is marked, along the triangles of its chart.
void growMarks(const Facets& facets, const Charts& charts, float margin,
               std::vector<std::uint8_t>& isMarked) {
  struct Step {
    std::uint32_t triangle;
    float way;
  };
  std::vector<Step> queue;
  for (std::uint32_t t = 0; t < facets.size(); ++t)
    if (isMarked[t]) queue.push_back({t, 0});
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const Step step = queue[next];
    for (std::uint32_t h = 3 * step.triangle; h < 3 * step.triangle + 3; ++h) {
      if (facets.opposite[h] == kNoHalfEdge) continue;
      const std::uint32_t t = facets.opposite[h] / 3;
      const float way = step.way + glm::length(facets.centre[t] - facets.centre[step.triangle]);
      if (isMarked[t] || way > margin || charts.ofTriangle[t] != charts.ofTriangle[step.triangle]) continue;
      isMarked[t] = 1;
      queue.push_back({t, way});
    }
  }
}

// Charts of the marked triangles along their own nearest axes, and of the others as they are.
Charts separate(const Facets& facets, const std::vector<glm::vec3>& normals,
                const std::array<ChartAxis, kChartAxes>& axes, const Charts& charts,
                const std::vector<std::uint8_t>& isMarked, const Progress& progress) {
  const auto first = std::uint32_t(charts.size());
  std::vector<std::uint32_t> keys = charts.ofTriangle, axisOfKey = charts.axis;
  for (std::uint32_t a = 0; a < kChartAxes; ++a) axisOfKey.push_back(a);
  for (std::size_t t = 0; t < facets.size(); ++t)
    if (isMarked[t]) keys[t] = first + nearestAxis(normals[t], axes, 0);
  return connectedCharts(facets, keys, axisOfKey, progress);
}

// Per chart 1 where it is not one of those before: these hide nothing that has not been put back into them already.
std::vector<std::uint8_t> changedCharts(const Charts& before, const Charts& after) {
  std::vector<std::uint32_t> size(before.size(), 0), part(after.size(), 0), from(after.size(), 0);
  std::vector<std::uint8_t> isChanged(after.size(), 0);
  for (std::size_t t = 0; t < before.ofTriangle.size(); ++t) {
    const std::uint32_t b = before.ofTriangle[t], a = after.ofTriangle[t];
    ++size[b];
    if (part[a]++ == 0)
      from[a] = b;
    else if (from[a] != b)
      isChanged[a] = 1;
  }
  for (std::size_t a = 0; a < after.size(); ++a)
    if (part[a] != size[from[a]] || after.axis[a] != before.axis[from[a]]) isChanged[a] = 1;
  return isChanged;
}

}  // namespace

void splitFolds(const Facets& facets, const std::vector<glm::vec3>& normals,
                const std::array<ChartAxis, kChartAxes>& axes, const FoldOptions& options, Charts& charts,
                const Progress& progress) {
  constexpr int kRounds = 3;
  std::vector<std::uint8_t> isChanged(charts.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    const Progress part = progress.part(double(round) / kRounds, double(round + 1) / kRounds);
    const Groups groups(charts.ofTriangle, charts.size());
    std::vector<std::uint8_t> isMarked(facets.size(), 0);
    parallelFor(
        std::ptrdiff_t(charts.size()),
        [&](std::ptrdiff_t c) {
          const std::size_t g = std::size_t(c);
          if (!isChanged[g]) return;
          markHidden(facets, groups.begin(g), groups.end(g), axes[charts.axis[g]], options.unit, isMarked);
        },
        part.part(0, 0.6));
    for (std::size_t t = 0; t < facets.size(); ++t)
      if (isChanged[charts.ofTriangle[t]] &&
          glm::dot(normals[t], axes[charts.axis[charts.ofTriangle[t]]].toward) < kLeastFacing)
        isMarked[t] = 1;
    if (std::find(isMarked.begin(), isMarked.end(), 1) == isMarked.end()) break;
    growMarks(facets, charts, kMargin * options.unit, isMarked);
    Charts parted = separate(facets, normals, axes, charts, isMarked, part.part(0.6, 0.9));
    mergeSmallCharts(facets, axes, options.tiny, options.tiny, parted);
    isChanged = changedCharts(charts, parted);
    charts = std::move(parted);
  }
}

}  // namespace sonoskin
