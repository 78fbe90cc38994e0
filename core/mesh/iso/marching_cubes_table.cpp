#include "core/mesh/iso/marching_cubes_table.h"

#include <cstddef>

namespace sonoskin {
namespace {

struct Loop {
  int length = 0;
  std::array<int, kCubeEdges> edges{};

  constexpr int at(int i) const { return edges[std::size_t(i % length)]; }
};

// The four corners of a face, counter-clockwise seen from outside the cube.
struct Face {
  std::array<int, 4> corners;
};

// Face `side` (0 low, 1 high) across `axis`. With u, v the next two axes, u x v points along the axis.
constexpr Face cubeFace(int axis, int side) {
  const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), base = side << axis;
  if (side == 1) return {{base, base | u, base | u | v, base | v}};
  return {{base, base | v, base | u | v, base | u}};
}

constexpr bool isInside(int cubeCase, int corner) { return (cubeCase >> corner) & 1; }

constexpr int edgeBetween(int cornerA, int cornerB) {
  const int low = cornerA < cornerB ? cornerA : cornerB, high = cornerA + cornerB - low;
  for (int e = 0; e < kCubeEdges; ++e)
    if (edgeStart(e) == low && edgeEnd(e) == high) return e;
  return -1;
}

// For each cut edge the cut edge that follows on its loop; -1 for the others. Walking around a face, an edge
// that enters the inside is joined to the edge that leaves the same run of inside corners. The neighbouring
// face walks that edge the other way round, so each cut edge enters once and leaves once.
constexpr std::array<int, kCubeEdges> loopSuccessors(int cubeCase) {
  std::array<int, kCubeEdges> next{};
  for (int& n : next) n = -1;
  for (int f = 0; f < 6; ++f) {
    const auto corners = cubeFace(f / 2, f % 2).corners;
    const auto corner = [&](int i) { return corners[std::size_t(i % 4)]; };
    for (int i = 0; i < 4; ++i) {
      if (isInside(cubeCase, corner(i)) || !isInside(cubeCase, corner(i + 1))) continue;
      int last = i + 1;
      while (isInside(cubeCase, corner(last + 1))) ++last;
      next[std::size_t(edgeBetween(corner(i), corner(i + 1)))] = edgeBetween(corner(last), corner(last + 1));
    }
  }
  return next;
}

constexpr bool shareFace(int edgeA, int edgeB) {
  for (int axis = 0; axis < 3; ++axis) {
    if (edgeAxis(edgeA) == axis || edgeAxis(edgeB) == axis) continue;
    if (((edgeStart(edgeA) ^ edgeStart(edgeB)) & (1 << axis)) == 0) return true;
  }
  return false;
}

// Whether the fan around the loop's vertex `apex` has no chord in a face of the cube.
constexpr bool isFanInsideCube(const Loop& loop, int apex) {
  for (int i = 2; i <= loop.length - 2; ++i)
    if (shareFace(loop.at(apex), loop.at(apex + i))) return false;
  return true;
}

constexpr void addFan(CubeCase& result, const Loop& loop) {
  int apex = 0;
  while (!isFanInsideCube(loop, apex)) ++apex;  // every loop has such a fan, else this would not compile
  for (int i = 1; i <= loop.length - 2; ++i)
    result.triangles[result.count++] = {std::uint8_t(loop.at(apex)), std::uint8_t(loop.at(apex + i)),
                                        std::uint8_t(loop.at(apex + i + 1))};
}

constexpr CubeCase triangulate(int cubeCase) {
  CubeCase result;
  auto next = loopSuccessors(cubeCase);
  for (int start = 0; start < kCubeEdges; ++start) {
    Loop loop;
    for (int e = start; next[std::size_t(e)] >= 0;) {
      loop.edges[std::size_t(loop.length++)] = e;
      const int following = next[std::size_t(e)];
      next[std::size_t(e)] = -1;
      e = following;
    }
    if (loop.length > 0) addFan(result, loop);
  }
  return result;
}

constexpr std::array<CubeCase, 256> allCases() {
  std::array<CubeCase, 256> cases{};
  for (int c = 0; c < 256; ++c) cases[std::size_t(c)] = triangulate(c);
  return cases;
}

}  // namespace

constexpr std::array<CubeCase, 256> kCubeCases = allCases();

}  // namespace sonoskin
