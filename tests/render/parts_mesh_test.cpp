#include "render/parts_mesh.h"

#include <gtest/gtest.h>

#include <set>

namespace sonoskin {
namespace {

// Four triangles around a vertex, in three parts.
TEST(PartsMesh, GivesEveryPartItsOwnVertices) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  mesh.normals.assign(5, {0, 0, 1});
  const std::vector<std::uint32_t> part{0, 1, 1, 2};
  const std::vector<PartTint> tints{{0, false}, {3, true}, {11, true}};
  const Mesh shown = makePartsMesh(mesh, part, tints);
  ASSERT_EQ(shown.triangles.size(), 4u);
  ASSERT_EQ(shown.visibility.size(), shown.positions.size());
  ASSERT_EQ(shown.normals.size(), shown.positions.size());
  EXPECT_EQ(shown.positions.size(), 5u + 2 + 3);  // the middle thrice, those between two parts twice
  std::set<float> codes;
  for (std::size_t t = 0; t < 4; ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(shown.positions[shown.triangles[t][i]], mesh.positions[mesh.triangles[t][i]]);
      EXPECT_EQ(shown.visibility[shown.triangles[t][i]], shown.visibility[shown.triangles[t][0]]);
      codes.insert(shown.visibility[shown.triangles[t][i]] * 64);
    }
  EXPECT_EQ(codes, (std::set<float>{0, 3 + kPartColours, 11 + kPartColours}));
}

}  // namespace
}  // namespace sonoskin
