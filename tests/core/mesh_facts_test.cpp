#include "core/mesh/facts/mesh_facts.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

TEST(MeshFacts, ASphereIsPrintable) {
  const MeshFacts facts = measureMesh(test::icosphere(4, 10, {}));
  EXPECT_TRUE(facts.printable());
  EXPECT_EQ(facts.pieces, 1u);
  EXPECT_NEAR(facts.volume, 4189, 20);
  EXPECT_NEAR(facts.area, 1257, 5);
  EXPECT_NEAR(facts.size.x, 20, 0.2);
}

TEST(MeshFacts, CrossingOpenOrTurnedMeshesAreNot) {
  const Mesh sphere = test::icosphere(3, 10, {});
  EXPECT_FALSE(measureMesh(joinPieces({sphere, test::icosphere(3, 9, {5.1f, 0.2f, 0.3f})})).printable());
  Mesh open = sphere;
  open.triangles.pop_back();
  EXPECT_EQ(measureMesh(open).volume, 0);
  EXPECT_FALSE(measureMesh(open).printable());
  Mesh turned = sphere;
  for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
  EXPECT_FALSE(measureMesh(turned).printable());
  EXPECT_FALSE(measureMesh({}).printable());
}

TEST(MeshFacts, Cancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(measureMesh(test::icosphere(3, 10, {}), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
