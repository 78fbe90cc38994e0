#include "core/mesh/iso/marching_cubes_table.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

namespace sonoskin {
namespace {

using Directed = std::pair<int, int>;

// The directed sides of a case's triangles that have no opposite: the loops' segments.
std::set<Directed> outline(const CubeCase& c) {
  std::set<Directed> sides;
  for (int t = 0; t < c.count; ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& edges = c.triangles[std::size_t(t)];
      const Directed side{edges[i], edges[(i + 1) % 3]};
      if (!sides.erase({side.second, side.first})) sides.insert(side);
    }
  return sides;
}

bool isCut(int cubeCase, int edge) {
  return ((cubeCase >> edgeStart(edge)) ^ (cubeCase >> edgeEnd(edge))) & 1;
}

TEST(MarchingCubesTable, HasTheKnownNumbersOfTriangles) {
  std::map<int, int> cases;
  int all = 0;
  for (const CubeCase& c : kCubeCases) {
    ++cases[c.count];
    all += c.count;
  }
  EXPECT_EQ(all, 820);
  EXPECT_EQ(cases, (std::map<int, int>{{0, 2}, {1, 16}, {2, 50}, {3, 80}, {4, 76}, {5, 32}}));
}

TEST(MarchingCubesTable, HasTheKnownLoops) {
  std::map<int, int> lengths;
  for (const CubeCase& c : kCubeCases) {
    std::map<int, int> next;
    for (const Directed& side : outline(c)) next.insert(side);
    int loops = 0;
    while (!next.empty()) {
      int length = 0;
      for (auto it = next.begin(); it != next.end(); ++length) {
        const int following = it->second;
        next.erase(it);
        it = next.find(following);
      }
      ++lengths[length];
      ++loops;
    }
    EXPECT_LE(loops, 4);
  }
  EXPECT_EQ(lengths, (std::map<int, int>{{3, 144}, {4, 66}, {5, 72}, {6, 52}, {7, 24}}));
}

TEST(MarchingCubesTable, UsesExactlyTheCutEdges) {
  for (int c = 0; c < 256; ++c) {
    std::set<int> used, cut;
    for (const Directed& side : outline(kCubeCases[std::size_t(c)])) used.insert(side.first);
    for (int e = 0; e < kCubeEdges; ++e)
      if (isCut(c, e)) cut.insert(e);
    EXPECT_EQ(used, cut) << "case " << c;
  }
}

// The segments that the high face of one cell shows must be the reversed ones of the low face of its
// neighbour.
TEST(MarchingCubesTable, NeighboursAgreeOnTheirCommonFace) {
  for (int axis = 0; axis < 3; ++axis) {
    const int bit = 1 << axis;
    const auto onFace = [&](int edge, int side) {
      return edgeAxis(edge) != axis && ((edgeStart(edge) >> axis) & 1) == side;
    };
    const auto toLowFace = [&](int edge) {
      for (int e = 0; e < kCubeEdges; ++e)
        if (edgeAxis(e) == edgeAxis(edge) && edgeStart(e) == (edgeStart(edge) & ~bit)) return e;
      return -1;
    };
    for (int left = 0; left < 256; ++left)
      for (int rest = 0; rest < 16; ++rest) {
        int right = 0;
        for (int corner = 0, free = 0; corner < 8; ++corner)
          right |= (corner & bit ? (rest >> free++) & 1 : (left >> (corner | bit)) & 1) << corner;
        std::set<Directed> expected, found;
        for (const auto& [a, b] : outline(kCubeCases[std::size_t(left)]))
          if (onFace(a, 1) && onFace(b, 1)) expected.insert({toLowFace(b), toLowFace(a)});
        for (const auto& [a, b] : outline(kCubeCases[std::size_t(right)]))
          if (onFace(a, 0) && onFace(b, 0)) found.insert({a, b});
        ASSERT_EQ(expected, found) << "axis " << axis << ", cases " << left << " and " << right;
      }
  }
}

}  // namespace
}  // namespace sonoskin
