#include "core/mesh/atlas/atlas_charts.h"
#include "core/mesh/surface_patches.h"

namespace sonoskin {
namespace {

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

// The label of two triangles beside t that agree, or its own.
std::uint32_t majority(const Facets& facets, const std::vector<std::uint32_t>& labels, std::size_t t) {
  std::array<std::uint32_t, 3> beside{};
  int count = 0;
  for (std::size_t h = 3 * t; h < 3 * t + 3; ++h) {
    const std::uint32_t opposite = facets.opposite[h];
    if (opposite != kNoHalfEdge) beside[std::size_t(count++)] = labels[opposite / 3];
  }
  if (count >= 2 && beside[0] == beside[1]) return beside[0];
  if (count == 3 && (beside[2] == beside[0] || beside[2] == beside[1])) return beside[2];
  return labels[t];
}

}  // namespace

std::vector<glm::vec3> smoothNormals(const Facets& facets, float length, const Progress& progress) {
  const SurfacePatches patches = growPatches(facets, 0.6f * length, progress.part(0, 0.4));
  std::vector<glm::vec4> sums(patches.size(), glm::vec4(0));
  for (std::size_t t = 0; t < facets.size(); ++t)
    sums[patches.ofTriangle[t]] += glm::vec4(facets.normal[t], 0);
  const std::vector<glm::vec4> smooth = smoothOverPatches(patches, sums, length, progress.part(0.4, 0.8));
  std::vector<glm::vec3> normals(facets.size());
  parallelItems(
      facets.size(), kFacetsPerTask,
      [&](std::size_t t) {
        const glm::vec3 n(atPoint(patches, smooth, patches.ofTriangle[t], facets.centre[t]));
        normals[t] = unitOr(n, unitOr(facets.normal[t], {0, 0, 1}));
      },
      progress.part(0.8, 1));
  return normals;
}

std::uint32_t nearestAxis(const glm::vec3& normal, const std::array<ChartAxis, kChartAxes>& axes,
                          float frontBias) {
  std::uint32_t best = 0;
  float most = glm::dot(normal, axes[0].toward) + frontBias;
  for (std::uint32_t a = 1; a < axes.size(); ++a) {
    const float facing = glm::dot(normal, axes[a].toward);
    if (facing > most) {
      most = facing;
      best = a;
    }
  }
  return best;
}

std::vector<std::uint32_t> labelTriangles(const Facets& facets, const std::vector<glm::vec3>& normals,
                                          const std::array<ChartAxis, kChartAxes>& axes,
                                          const Progress& progress) {
  constexpr float kFrontBias = 0.15f;
  constexpr int kRounds = 4;
  std::vector<std::uint32_t> labels(facets.size()), filtered(facets.size());
  parallelItems(
      facets.size(), kFacetsPerTask,
      [&](std::size_t t) { labels[t] = nearestAxis(normals[t], axes, kFrontBias); }, progress.part(0, 0.3));
  for (int round = 0; round < kRounds; ++round) {
    parallelItems(
        facets.size(), kFacetsPerTask, [&](std::size_t t) { filtered[t] = majority(facets, labels, t); },
        progress.part(0.3, 1).cancelOnly());
    labels.swap(filtered);
  }
  return labels;
}

}  // namespace sonoskin
