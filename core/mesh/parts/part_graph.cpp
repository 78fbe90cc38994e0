#include "core/mesh/parts/part_graph.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sonoskin {
namespace {

constexpr float kPatchShare = 0.6f;  // a patch's radius as a share of the scale

// Areas and normals of the patches, from their triangles.
void sumTriangles(const Facets& facets, PartGraph& graph) {
  const std::size_t count = graph.patches.size();
  graph.area.assign(count, 0);
  graph.normal.assign(count, glm::vec3(0));
  for (std::size_t t = 0; t < facets.size(); ++t) {
    const std::uint32_t p = graph.patches.ofTriangle[t];
    graph.area[p] += facets.area(t);
    graph.normal[p] += facets.normal[t];
  }
  for (glm::vec3& n : graph.normal) {
    const float length = glm::length(n);
    n = length > 0 ? n / length : glm::vec3(0);
  }
}

// The lengths of the borders between patches.
void measureBorders(const Facets& facets, PartGraph& graph) {
  const SurfacePatches& patches = graph.patches;
  const auto& [positions, triangles] = std::tie(facets.mesh.positions, facets.mesh.triangles);
  graph.border.assign(patches.neighbours.size(), 0);
  for (std::uint32_t h = 0; h < facets.opposite.size(); ++h) {
    if (facets.opposite[h] == kNoHalfEdge) continue;
    const std::uint32_t a = patches.ofTriangle[h / 3], b = patches.ofTriangle[facets.opposite[h] / 3];
    if (a == b) continue;
    const auto begin = patches.neighbours.begin() + patches.start[a],
               end = patches.neighbours.begin() + patches.start[a + 1];
    const auto entry = std::lower_bound(begin, end, b) - patches.neighbours.begin();
    graph.border[std::size_t(entry)] +=
        glm::distance(positions[originOf(triangles, h)], positions[originOf(triangles, nextHalfEdge(h))]);
  }
}

// Half of length times turning angle, of the edge of half-edge `h`; > 0 where the surface is convex.
float edgeCurvature(const Facets& facets, std::uint32_t h) {
  const glm::vec3 &a = facets.normal[h / 3], &b = facets.normal[facets.opposite[h] / 3];
  const glm::vec3 edge = facets.mesh.positions[originOf(facets.mesh.triangles, nextHalfEdge(h))] -
                         facets.mesh.positions[originOf(facets.mesh.triangles, h)];
  const float areas = std::sqrt(glm::dot(a, a) * glm::dot(b, b)), length = glm::length(edge);
  if (!(areas > 0) || !(length > 0)) return 0;
  const float sine = glm::dot(glm::cross(a, b), edge) / areas, cosine = glm::dot(a, b) / areas;
  // Nearly all edges turn by little, where the sine stands for the angle.
  return 0.5f * (cosine > 0.95f ? sine : length * std::atan2(sine / length, cosine));
}

// The angle by which the surface turns at every patch.
void measureCreases(const Facets& facets, PartGraph& graph, float scale, const Progress& progress) {
  std::vector<glm::vec4> sums(graph.size(), glm::vec4(0));  // integral of mean curvature, area
  for (std::uint32_t h = 0; h < facets.opposite.size(); ++h) {
    if (facets.opposite[h] == kNoHalfEdge || facets.opposite[h] < h) continue;
    const float half = 0.5f * edgeCurvature(facets, h);
    sums[graph.patches.ofTriangle[h / 3]].x += half;
    sums[graph.patches.ofTriangle[facets.opposite[h] / 3]].x += half;
  }
  for (std::size_t p = 0; p < graph.size(); ++p) sums[p].y = graph.area[p];
  const std::vector<glm::vec4> smooth = smoothOverPatches(graph.patches, sums, scale, progress);
  constexpr float kRootTwoPi = 2.5066283f;
  graph.crease.assign(graph.size(), 0);
  for (std::size_t p = 0; p < graph.size(); ++p)
    if (smooth[p].y > 0) graph.crease[p] = -2 * kRootTwoPi * scale * smooth[p].x / smooth[p].y;
}

// How far the normals around every patch agree.
void measureFlatness(PartGraph& graph, float scale, const Progress& progress) {
  std::vector<glm::vec4> sums(graph.size());
  for (std::size_t p = 0; p < graph.size(); ++p) sums[p] = graph.area[p] * glm::vec4(graph.normal[p], 1);
  const std::vector<glm::vec4> smooth = smoothOverPatches(graph.patches, sums, scale, progress);
  graph.flatness.assign(graph.size(), 1);
  for (std::size_t p = 0; p < graph.size(); ++p)
    if (smooth[p].w > 0) graph.flatness[p] = glm::length(glm::vec3(smooth[p])) / smooth[p].w;
}

}  // namespace

PartGraph makePartGraph(const Facets& facets, float scale, const Progress& progress) {
  PartGraph graph;
  graph.patches = growPatches(facets, kPatchShare * scale, progress.part(0, 0.6));
  sumTriangles(facets, graph);
  measureBorders(facets, graph);
  measureCreases(facets, graph, scale, progress.part(0.6, 0.8));
  measureFlatness(graph, scale, progress.part(0.8, 1));
  return graph;
}

}  // namespace sonoskin
