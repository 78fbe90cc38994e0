#include "core/rbf/brick.h"

#include <gtest/gtest.h>

#include <random>

namespace sonoskin {
namespace {

TEST(Brick, ShiftedTellsOfTheNextNodeAlongEachAxis) {
  std::mt19937_64 random(3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const NodeSet own = random(), next = random();
    for (int axis = 0; axis < 3; ++axis) {
      const NodeSet result = shifted(own, next, axis);
      for (int n = 0; n < int(kBrickNodes); ++n) {
        glm::ivec3 place = nodePlace(n);
        ASSERT_EQ(brickNode(place.x, place.y, place.z), n);
        const bool crosses = ++place[axis] == kBrickEdge;
        if (crosses) place[axis] = 0;
        const NodeSet from = crosses ? next : own;
        ASSERT_EQ((result >> n) & 1, (from >> brickNode(place.x, place.y, place.z)) & 1);
      }
    }
  }
}

TEST(Brick, LayersHoldTheNodesOfOnePlace) {
  for (int n = 0; n < int(kBrickNodes); ++n)
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kBrickEdge; ++i)
        ASSERT_EQ((kLayer[std::size_t(axis)][std::size_t(i)] >> n) & 1, NodeSet(nodePlace(n)[axis] == i));
}

}  // namespace
}  // namespace sonoskin
