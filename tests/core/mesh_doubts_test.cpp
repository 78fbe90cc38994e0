#include "core/mesh/facts/mesh_doubts.h"

#include <gtest/gtest.h>

#include "tests/support/solids.h"

namespace sonoskin {
namespace {

Mesh head(double radius = 40) {
  return test::solid(
      [&](const glm::dvec3& x) {
        return test::ball(x, {5, 5, 5}, radius);
      },
      glm::dvec3(radius + 8), radius / 8);
}

// The half that a probe sees.
Mesh face() {
  Mesh mesh = head();
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return mesh.positions[t[0]].y > 5; });
  return mesh;
}

TEST(MeshDoubts, AFaceInMillimetresHasNone) {
  EXPECT_TRUE(meshDoubts(head()).empty());
  EXPECT_TRUE(meshDoubts(face()).empty());
  EXPECT_TRUE(pairDoubts(head(), face()).empty());
}

TEST(MeshDoubts, TellsOtherUnits) {
  Mesh metres = head();
  scaleMesh(metres, 0.001f);
  ASSERT_EQ(meshDoubts(metres).size(), 1u);
  EXPECT_NE(meshDoubts(metres)[0].find("--scale"), std::string::npos);
  scaleMesh(metres, 1000);
  EXPECT_TRUE(meshDoubts(metres).empty());
}

TEST(MeshDoubts, TellsWhatIsInsideOut) {
  for (Mesh mesh : {head(), face()}) {
    flipMesh(mesh);
    ASSERT_EQ(meshDoubts(mesh).size(), 1u);
    EXPECT_NE(meshDoubts(mesh)[0].find("--flip"), std::string::npos);
    flipMesh(mesh);
    EXPECT_TRUE(meshDoubts(mesh).empty());
  }
}

TEST(MeshDoubts, TellsPairsThatDoNotBelongTogether) {
  Mesh metres = head(), far = head();
  scaleMesh(metres, 0.001f);
  EXPECT_FALSE(pairDoubts(head(), metres).empty());
  for (glm::vec3& p : far.positions) p.x += 500;
  ASSERT_EQ(pairDoubts(head(), far).size(), 1u);
}

}  // namespace
}  // namespace sonoskin
