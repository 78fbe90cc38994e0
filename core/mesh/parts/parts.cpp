#include "core/mesh/parts/parts.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/parts/merge_regions.h"
#include "core/mesh/parts/strands.h"
#include "core/mesh/parts/watershed.h"

namespace sonoskin {
namespace {

// mm: lids and lips are narrower, the fold between a hand and a cheek is not.
constexpr float kScale = 3;

// The ranks by area of parts 0 to count - 1; those without triangles come last.
std::vector<std::uint32_t> ranksByArea(const Facets& facets, const std::vector<std::uint32_t>& part,
                                       std::size_t count) {
  std::vector<double> area(count, 0);
  for (std::size_t t = 0; t < part.size(); ++t) area[part[t]] += double(facets.area(t));
  std::vector<bool> used(count, false);
  for (const std::uint32_t p : part) used[p] = true;
  std::vector<std::uint32_t> order(count), rank(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return used[a] != used[b] ? bool(used[a]) : area[a] > area[b];
  });
  for (std::uint32_t r = 0; r < count; ++r) rank[order[r]] = r;
  return rank;
}

void sumParts(const Facets& facets, SurfaceParts& result) {
  constexpr double kFromCrease = 1 / (2 * 2.5066283 * double(kScale));  // see makePartGraph
  std::vector<glm::dvec3> centre(result.parts.size(), glm::dvec3(0));
  for (std::size_t t = 0; t < facets.size(); ++t) {
    Part& part = result.parts[result.ofTriangle[t]];
    const double area = double(facets.area(t)) + 1e-12;  // degenerate triangles have a centre, too
    part.area += area;
    centre[result.ofTriangle[t]] += area * glm::dvec3(facets.centre[t]);
    part.curvature -= area * kFromCrease * double(result.graph.crease[result.graph.patches.ofTriangle[t]]);
  }
  for (std::size_t p = 0; p < centre.size(); ++p) {
    result.parts[p].centre = glm::vec3(centre[p] / result.parts[p].area);
    result.parts[p].curvature /= result.parts[p].area;
  }
}

// The triangle of every part that is nearest to its centre.
void findPlaces(const Facets& facets, std::vector<Part>& parts, const std::vector<std::uint32_t>& part) {
  std::vector<float> least(parts.size(), std::numeric_limits<float>::infinity());
  for (std::size_t t = 0; t < facets.size(); ++t) {
    Part& p = parts[part[t]];
    const glm::vec3 away = facets.centre[t] - p.centre;
    if (glm::dot(away, away) >= least[part[t]]) continue;
    least[part[t]] = glm::dot(away, away);
    p.place = facets.centre[t];
  }
}

}  // namespace

void describeParts(const Facets& facets, SurfaceParts& parts) {
  std::uint32_t count = 0;
  for (const std::uint32_t p : parts.ofTriangle) count = std::max(count, p + 1);
  const std::vector<std::uint32_t> rank = ranksByArea(facets, parts.ofTriangle, count);
  std::uint32_t used = 0;
  for (std::uint32_t& p : parts.ofTriangle) {
    p = rank[p];
    used = std::max(used, p + 1);
  }
  parts.parts.assign(used, {});
  sumParts(facets, parts);
  findPlaces(facets, parts.parts, parts.ofTriangle);
}

SurfaceParts cutParts(const Mesh& mesh, const Progress& progress) {
  SurfaceParts result;
  const Facets facets(mesh, progress.part(0, 0.3));
  result.graph = makePartGraph(facets, kScale, progress.part(0.3, 0.9));
  std::vector<std::uint32_t> regions = creaseBasins(result.graph);
  const std::vector<bool> strand = separateStrands(result.graph, regions);
  const std::vector<std::uint32_t> before = regions;
  progress.update(0.92);
  regions = mergeRegions(result.graph, regions, {}, strand);
  std::vector<bool> strandLeft(regions.size(), false);
  for (std::size_t p = 0; p < regions.size(); ++p)
    if (strand[before[p]]) strandLeft[regions[p]] = true;
  joinStrands(result.graph, regions, strandLeft, MergeRules{}.smallArea);
  progress.update(0.95);
  result.ofTriangle.resize(facets.size());
  for (std::size_t t = 0; t < facets.size(); ++t)
    result.ofTriangle[t] = regions[result.graph.patches.ofTriangle[t]];
  describeParts(facets, result);
  progress.update(1);
  return result;
}

std::uint32_t triangleNearest(const Mesh& mesh, const glm::vec3& point) {
  require(!mesh.empty(), "There is no surface to choose from.");
  std::uint32_t nearest = 0;
  float least = std::numeric_limits<float>::infinity();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto& x = mesh.positions;
    const glm::vec3 d = closestPointOnTriangle(point, x[a], x[b], x[c]).position - point;
    if (glm::dot(d, d) >= least) continue;
    least = glm::dot(d, d);
    nearest = t;
  }
  return nearest;
}

}  // namespace sonoskin
