#include "core/mesh/surface_curvature.h"

#include <cmath>

#include "core/mesh/surface_patches.h"

namespace sonoskin {
namespace {

// Half of length times turning angle of an edge: what it adds to the integral of mean curvature. Each of its two
// triangles gets one half of that.
float edgeCurvature(const Facets& facets, std::uint32_t h) {
  if (facets.opposite[h] == kNoHalfEdge) return 0;
  const glm::vec3 &a = facets.normal[h / 3], &b = facets.normal[facets.opposite[h] / 3];
  const glm::vec3 edge = facets.mesh.positions[originOf(facets.mesh.triangles, nextHalfEdge(h))] -
                         facets.mesh.positions[originOf(facets.mesh.triangles, h)];
  const float length = glm::length(edge);
  if (!(length > 0)) return 0;
  // A convex edge turns the normal around the edge's own direction.
  const float angle = std::atan2(glm::dot(glm::cross(a, b), edge) / length, glm::dot(a, b));
  return 0.25f * length * angle;
}

std::vector<glm::vec4> sumOverPatches(const Facets& facets, const SurfacePatches& patches,
                                      const Progress& progress) {
  std::vector<glm::vec2> ofTriangle(facets.size());  // curvature, area
  parallelItems(
      facets.size(), kFacetsPerTask,
      [&](std::size_t t) {
        const auto h = std::uint32_t(3 * t);
        const float sum =
            edgeCurvature(facets, h) + edgeCurvature(facets, h + 1) + edgeCurvature(facets, h + 2);
        ofTriangle[t] = {sum, facets.area(t)};
      },
      progress);
  std::vector<glm::vec4> sums(patches.size(), glm::vec4(0));
  for (std::size_t t = 0; t < facets.size(); ++t)
    sums[patches.ofTriangle[t]] += glm::vec4(ofTriangle[t], 0, 0);
  return sums;
}

}  // namespace

std::vector<float> meanCurvature(const Mesh& mesh, double radius, const Progress& progress) {
  const Facets facets(mesh, progress.part(0, 0.2));
  return meanCurvature(facets, radius, progress.part(0.2, 1));
}

std::vector<float> meanCurvature(const Facets& facets, double radius, const Progress& progress) {
  const Mesh& mesh = facets.mesh;
  const SurfacePatches patches = growPatches(facets, float(0.3 * radius), progress.part(0, 0.4));
  const std::vector<glm::vec4> sums = sumOverPatches(facets, patches, progress.part(0.4, 0.6));
  std::vector<glm::vec4> values = smoothOverPatches(patches, sums, float(radius), progress.part(0.6, 0.9));
  for (glm::vec4& v : values) v.x = v.y > 0 ? v.x / v.y : 0;
  std::vector<std::uint32_t> home(mesh.positions.size(), kNoHalfEdge);
  for (std::size_t t = mesh.triangles.size(); t-- > 0;)
    for (const std::uint32_t v : mesh.triangles[t]) home[v] = patches.ofTriangle[t];
  std::vector<float> curvature(mesh.positions.size(), 0);
  parallelItems(
      curvature.size(), kFacetsPerTask,
      [&](std::size_t v) {
        if (home[v] != kNoHalfEdge) curvature[v] = atPoint(patches, values, home[v], mesh.positions[v]).x;
      },
      progress.part(0.9, 1));
  return curvature;
}

}  // namespace sonoskin
