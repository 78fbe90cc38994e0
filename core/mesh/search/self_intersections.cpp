#include "core/mesh/search/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/parallel_blocks.h"
#include "core/mesh/search/triangle_tree.h"

namespace sonoskin {
namespace {

constexpr std::size_t kLeavesPerTask = 512;

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

using Sides = std::array<double, 3>;

// On which side of a triangle's plane another one's corners lie; a corner at `shared` (3: none) lies in it.
Sides sidesOf(const Corners& corners, const Corners& plane, std::size_t shared) {
  Sides sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = i == shared ? 0 : volume6(plane[0], plane[1], plane[2], corners[i]);
  return sides;
}

bool onOneSide(const Sides& s) {
  return (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0);
}

// Whether a side of `a` passes through `b`, whose plane has a's corners on those sides.
bool pierces(const Corners& a, const Sides& side, const Corners& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (((side[i] > 0 && side[j] < 0) || (side[i] < 0 && side[j] > 0)) && piercesInside(a[i], a[j], b))
      return true;
  }
  return false;
}

Corners cornersOf(const Mesh& mesh, const Triangle& t) {
  return {glm::dvec3(mesh.positions[t[0]]), glm::dvec3(mesh.positions[t[1]]),
          glm::dvec3(mesh.positions[t[2]])};
}

// Most pairs are neighbours along a side, which need no arithmetic.
bool shareASide(const Triangle& a, const Triangle& b) {
  int common = 0;
  for (const std::uint32_t i : a) common += i == b[0] || i == b[1] || i == b[2];
  return common >= 2;
}

std::size_t countOf(const Mesh& mesh, const TriangleTree& tree, std::size_t leaf) {
  std::size_t count = 0;
  tree.forEachPair(leaf, [&](std::uint32_t t, std::uint32_t u) {
    const Triangle &a = mesh.triangles[t], &b = mesh.triangles[u];
    if (!shareASide(a, b)) count += trianglesCross(cornersOf(mesh, a), cornersOf(mesh, b));
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
  if (common >= 2) return false;
  const Sides ofA = sidesOf(a, b, inA);
  if (onOneSide(ofA)) return false;
  const Sides ofB = sidesOf(b, a, inB);
  return !onOneSide(ofB) && (pierces(a, ofA, b) || pierces(b, ofB, a));
}

std::size_t countSelfIntersections(const Mesh& mesh, const Progress& progress) {
  if (mesh.empty()) return 0;
  const TriangleTree tree(mesh);
  std::vector<std::size_t> counts(blockCount(tree.leaves(), kLeavesPerTask), 0);
  parallelBlocks(
      tree.leaves(), kLeavesPerTask,
      [&](std::size_t first, std::size_t end) {
        std::size_t& count = counts[first / kLeavesPerTask];
        for (std::size_t leaf = first; leaf < end; ++leaf) count += countOf(mesh, tree, leaf);
      },
      progress);
  return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

}  // namespace sonoskin
