#include "core/mesh/atlas/atlas.h"

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/mesh/atlas/atlas_charts.h"
#include "core/mesh/atlas/atlas_folds.h"
#include "core/mesh/atlas/atlas_nest.h"
#include "core/mesh/atlas/atlas_pack.h"
#include "core/mesh/atlas/atlas_skirts.h"

namespace sonoskin {
namespace {

constexpr int kGutter = 3;  // texels

struct Extent {
  glm::vec2 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};
  void include(const glm::vec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

glm::vec2 flat(const ChartAxis& axis, const glm::vec3& p) {
  return {glm::dot(axis.u, p), glm::dot(axis.v, p)};
}

// Layout: the mm of every chart, with its skirt, and where it lies in the picture.
//   coarse   per chart: how many times as large its texels are
struct Layout {
  std::vector<Extent> extents;
  std::vector<float> coarse;
  Packing packing;
  float texel = 0;
};

std::vector<float> coarseness(const Charts& charts, std::size_t fine) {
  std::vector<float> coarse(charts.size(), 1);
  for (std::size_t t = fine; t < charts.ofTriangle.size(); ++t) coarse[charts.ofTriangle[t]] = kCoarser;
  return coarse;
}

std::vector<Extent> chartExtents(const Mesh& mesh, const std::array<ChartAxis, kChartAxes>& axes,
                                 const Charts& charts,
                                 const std::vector<std::vector<std::uint32_t>>& skirts) {
  std::vector<Extent> extents(charts.size());
  const auto include = [&](std::uint32_t chart, std::size_t triangle) {
    for (const std::uint32_t v : mesh.triangles[triangle])
      extents[chart].include(flat(axes[charts.axis[chart]], mesh.positions[v]));
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) include(charts.ofTriangle[t], t);
  for (std::uint32_t c = 0; c < charts.size(); ++c)
    for (const std::uint32_t t : skirts[c]) include(c, t);
  return extents;
}

Layout layOut(std::vector<Extent> extents, std::vector<float> coarse, const AtlasOptions& options) {
  constexpr int kAttempts = 100;
  Layout layout{std::move(extents), std::move(coarse), {}, float(options.texel)};
  for (int attempt = 0;; ++attempt) {
    std::vector<glm::ivec2> boxes;
    bool fits = true;
    for (std::size_t c = 0; c < layout.extents.size(); ++c) {
      const Extent& e = layout.extents[c];
      const glm::vec2 box = glm::ceil((e.high - e.low) / (layout.texel * layout.coarse[c]));
      fits = fits && box.x < float(options.maxSize) && box.y < float(options.maxSize);
      boxes.emplace_back(glm::min(box, glm::vec2(float(options.maxSize))));
    }
    layout.packing = packBoxes(boxes, kGutter);
    const glm::vec2 size(layout.packing.size);
    const float tooLong = fits ? std::max(size.x, size.y) / float(options.maxSize) : 1.2f,
                tooLarge = std::sqrt(size.x * size.y / float(options.maxTexels));
    // Gutters do not shrink: thousands of specks may never fit.
    if ((tooLong <= 1 && tooLarge <= 1) || attempt == kAttempts) return layout;
    layout.texel *= 1.03f * std::max({1.f, tooLong, std::min(tooLarge, 2.f)});
  }
}

Corners place(const Mesh& mesh, std::uint32_t triangle, const ChartAxis& axis, const Layout& layout,
              std::uint32_t chart) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = (flat(axis, mesh.positions[mesh.triangles[triangle][i]]) - layout.extents[chart].low) /
                     (layout.texel * layout.coarse[chart]) +
                 glm::vec2(layout.packing.place[chart]);
  return corners;
}

void placeSkirts(const Mesh& mesh, const std::array<ChartAxis, kChartAxes>& axes, const Charts& charts,
                 const std::vector<std::vector<std::uint32_t>>& skirts, const Layout& layout, Atlas& atlas) {
  for (std::uint32_t c = 0; c < charts.size(); ++c)
    // The nearest last, so that it is drawn over farther parts of a skirt that folds.
    for (auto t = skirts[c].rbegin(); t != skirts[c].rend(); ++t) {
      atlas.skirts.push_back(*t);
      atlas.skirtChart.push_back(c);
      atlas.skirtCorners.push_back(place(mesh, *t, axes[charts.axis[c]], layout, c));
    }
}

Charts findCharts(const Facets& facets, const AtlasOptions& options,
                  const std::array<ChartAxis, kChartAxes>& axes, const Progress& progress) {
  // mm²; surfaces that are small as a whole have smaller charts. Small ones stay: merged into a
  // neighbour they are seen from the side or turned over, and light that is blurred there is wrong by far more than at a
  // few more seams.                                                                     [theory/skin.md, 3.2, step 4]
  const double area = facets.area(), square = options.unit * options.unit,
               smallest = std::min(std::max(18 * square, area / 800), area / 150),
               tiny = std::min(0.6 * square, area / 5000);
  const std::vector<glm::vec3> normals =
      smoothNormals(facets, float(options.unit * options.normalLength), progress.part(0, 0.4));
  const std::vector<std::uint32_t> labels = labelTriangles(facets, normals, axes, progress.part(0.4, 0.5));
  std::vector<std::uint32_t> axisOfLabel;
  for (std::uint32_t a = 0; a < kChartAxes; ++a) axisOfLabel.push_back(a);
  Charts charts = connectedCharts(facets, labels, axisOfLabel, progress.part(0.5, 0.6));
  mergeSmallCharts(facets, axes, smallest, tiny, charts);
  splitFolds(facets, normals, axes, {tiny, float(options.unit)}, charts, progress.part(0.6, 0.9));
  return charts;
}

}  // namespace

Atlas buildAtlas(const Mesh& mesh, const AtlasOptions& options, const Progress& progress) {
  const Facets facets(mesh, progress.part(0, 0.1));
  return buildAtlas(facets, options, progress.part(0.1, 1));
}

Atlas buildAtlas(const Facets& facets, const AtlasOptions& options, const Progress& progress) {
  const Mesh& mesh = facets.mesh;
  require(options.texel > 0 && options.unit > 0 && options.maxSize >= 16 && options.maxTexels >= 256,
          "A texel needs a size, and an atlas at least 16 texels a side.");
  const std::array<ChartAxis, kChartAxes> axes = chartAxes(options.front);
  const Charts charts = findCharts(facets, options, axes, progress.part(0, 0.6));
  auto skirts = chartSkirts(facets, axes, charts, float(options.skirt), progress.part(0.6, 0.9));
  const std::vector<float> coarse = coarseness(charts, options.fine);
  for (std::size_t c = 0; c < skirts.size(); ++c)
    std::erase_if(skirts[c], [&](std::uint32_t t) { return coarse[c] > 1 || t >= options.fine; });
  const Layout layout = layOut(chartExtents(mesh, axes, charts, skirts), coarse, options);

  Atlas atlas;
  atlas.size = layout.packing.size;
  atlas.texel = layout.texel;
  atlas.unit = float(options.unit);
  atlas.charts = int(charts.size());
  atlas.chart = charts.ofTriangle;
  atlas.corners.resize(mesh.triangles.size());
  parallelItems(
      mesh.triangles.size(), kFacetsPerTask,
      [&](std::size_t t) {
        const std::uint32_t c = atlas.chart[t];
        atlas.corners[t] = place(mesh, std::uint32_t(t), axes[charts.axis[c]], layout, c);
      },
      progress.part(0.9, 1));
  placeSkirts(mesh, axes, charts, skirts, layout, atlas);
  nestCharts(layout.packing.place, kGutter, atlas);
  return atlas;
}

}  // namespace sonoskin
