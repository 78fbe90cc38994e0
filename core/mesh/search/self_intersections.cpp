#include "core/mesh/search/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/parallel_blocks.h"
#include "core/mesh/search/triangle_tree.h"

namespace sonoskin {
namespace {

constexpr std::size_t kTrianglesPerTask = 2048;

// Six times the volume of a tetrahedron; its sign tells the side of d. Zero if that is within the rounding.
double volume6(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const glm::dvec3 ab = b - a, ac = c - a, ad = d - a;
  const glm::dvec3 extent = glm::max(glm::abs(ab), glm::max(glm::abs(ac), glm::abs(ad)));
  const double size = std::max({extent.x, extent.y, extent.z});
  const double volume = glm::dot(glm::cross(ab, ac), ad);
  return std::abs(volume) > 1e-14 * size * size * size ? volume : 0;
}

// Whether the segment from p to q, which ends on opposite sides of the plane, passes through the triangle.
bool piercesInside(const glm::dvec3& p, const glm::dvec3& q, const Corners& t) {
  const double u = volume6(p, q, t[0], t[1]), v = volume6(p, q, t[1], t[2]), w = volume6(p, q, t[2], t[0]);
  if (u == 0 && v == 0 && w == 0) return false;  // all in one plane
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

// Whether a side of `a` passes through `b`; a side at corner `shared` of a (3: none) touches it anyway.
bool pierces(const Corners& a, const Corners& b, std::size_t shared) {
  std::array<double, 3> side;
  for (std::size_t i = 0; i < 3; ++i) side[i] = i == shared ? 0 : volume6(b[0], b[1], b[2], a[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (((side[i] > 0 && side[j] < 0) || (side[i] < 0 && side[j] > 0)) && piercesInside(a[i], a[j], b))
      return true;
  }
  return false;
}

Box boxOf(const Mesh& mesh, const Triangle& t) {
  const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

Corners cornersOf(const Mesh& mesh, const Triangle& t) {
  return {glm::dvec3(mesh.positions[t[0]]), glm::dvec3(mesh.positions[t[1]]),
          glm::dvec3(mesh.positions[t[2]])};
}

std::size_t countOf(const Mesh& mesh, const TriangleTree& tree, std::uint32_t triangle) {
  const Box box = boxOf(mesh, mesh.triangles[triangle]);
  const Corners corners = cornersOf(mesh, mesh.triangles[triangle]);
  std::size_t count = 0;
  tree.forEachNear(box, [&](std::uint32_t other) {
    if (other <= triangle || !overlap(box, boxOf(mesh, mesh.triangles[other]))) return;
    count += trianglesCross(corners, cornersOf(mesh, mesh.triangles[other]));
  });
  return count;
}

}  // namespace

bool trianglesCross(const Corners& a, const Corners& b) {
  std::size_t common = 0, inA = 3, inB = 3;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a[i] == b[j]) {
        ++common;
        inA = i;
        inB = j;
      }
  return common < 2 && (pierces(a, b, inA) || pierces(b, a, inB));
}

std::size_t countSelfIntersections(const Mesh& mesh, const Progress& progress) {
  if (mesh.empty()) return 0;
  const TriangleTree tree(mesh);
  std::vector<std::size_t> counts(blockCount(mesh.triangles.size(), kTrianglesPerTask), 0);
  parallelBlocks(
      mesh.triangles.size(), kTrianglesPerTask,
      [&](std::size_t first, std::size_t end) {
        std::size_t& count = counts[first / kTrianglesPerTask];
        for (std::size_t t = first; t < end; ++t) count += countOf(mesh, tree, std::uint32_t(t));
      },
      progress);
  return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

}  // namespace sonoskin
