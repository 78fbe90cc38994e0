#include <cmath>
#include <limits>

#include "core/mesh/atlas/atlas.h"
#include "core/mesh/atlas/atlas_charts.h"
#include "core/mesh/atlas/atlas_rim.h"

namespace sonoskin {
namespace {

constexpr float kGutter = 3;  // texels around everything

// The middle one of all triangles' mm per unit of their coordinates; 0 where they have no area.
double middleScale(const Facets& facets) {
  std::vector<double> scales;
  for (std::size_t t = 0; t < facets.size(); ++t) {
    const double area = double(facets.area(t)),
                 flat = 0.5 * std::abs(double(Barycentric(facets.mesh.cornerUvs[t]).area));
    if (area > 0 && flat > 0) scales.push_back(std::sqrt(area / flat));
  }
  if (2 * scales.size() < facets.size()) return 0;
  const auto middle = scales.begin() + std::ptrdiff_t(scales.size() / 2);
  std::nth_element(scales.begin(), middle, scales.end());
  return *middle;
}

// Texels per unit of a picture that has no more than `most` of them.
//   solves   (x t + g) (y t + g) = most for t, with gutters g and the texel that is rounded up to
float mostPerUnit(const glm::dvec2& extent, double most) {
  const double g = 2 * double(kGutter) + 1, b = g * (extent.x + extent.y), c = most - g * g;
  return float(2 * c / (b + std::sqrt(b * b + 4 * extent.x * extent.y * c)));
}

// Charts end where coordinates do.
void numberCharts(Facets facets, Atlas& atlas) {
  atlas.chart.assign(facets.size(), 0);
  for (const RimSide& side : rimSides(facets, atlas))
    facets.opposite[3 * side.triangle + side.corner] = kNoHalfEdge;
  Charts charts = connectedCharts(facets, atlas.chart, {0});
  atlas.charts = int(charts.size());
  atlas.chart = std::move(charts.ofTriangle);
}

}  // namespace

std::optional<Atlas> atlasFromCoordinates(const Mesh& mesh, const AtlasOptions& options) {
  if (mesh.empty() || mesh.cornerUvs.size() != mesh.triangles.size()) return {};
  glm::vec2 low(std::numeric_limits<float>::max()), high = -low;
  for (const Corners& corners : mesh.cornerUvs)
    for (const glm::vec2& uv : corners) {
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return {};
      low = glm::min(low, uv);
      high = glm::max(high, uv);
    }
  const Facets facets(mesh);
  const double scale = middleScale(facets);
  if (!(scale > 0)) return {};
  const glm::vec2 extent = high - low;
  const float room = float(options.maxSize) - 2 * kGutter - 1;
  const float texels = std::min({float(scale / options.texel), room / std::max(extent.x, extent.y),
                                 mostPerUnit(glm::dvec2(extent), options.maxTexels)});
  Atlas atlas;
  atlas.size = glm::ivec2(glm::ceil(extent * texels + 2 * kGutter));
  atlas.texel = float(scale) / texels;
  atlas.unit = float(options.unit);
  for (const Corners& corners : mesh.cornerUvs) {
    Corners& placed = atlas.corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) placed[i] = (corners[i] - low) * texels + kGutter;
  }
  numberCharts(facets, atlas);
  if (checkOverlap(facets, atlas).overlap > 0.01) return {};
  return atlas;
}

}  // namespace sonoskin
