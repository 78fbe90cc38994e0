#include "core/mesh/repair/decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "core/base/error.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/half_edges.h"
#include "core/mesh/search/self_intersections.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

TEST(Decimate, ASphereStaysRoundAndManifold) {
  const Mesh sphere = test::icosphere(6, 10, {});  // 81,920 triangles
  const Mesh few = decimateMesh(sphere, 5000);
  EXPECT_LE(few.triangles.size(), 5100u);
  EXPECT_GE(few.triangles.size(), 4500u);
  const MeshCheck check = checkMesh(few);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
  EXPECT_EQ(countSelfIntersections(few), 0u);
  EXPECT_NEAR(enclosedVolume(few), enclosedVolume(sphere), 0.005 * enclosedVolume(sphere));
  for (const auto& [a, b, c] : few.triangles)  // sagitta of triangles of 0.75 mm: 0.02 mm
    EXPECT_NEAR(glm::length((few.positions[a] + few.positions[b] + few.positions[c]) / 3.f), 10.f, 0.1f);
}

TEST(Decimate, VerticesAndBordersAreThoseOfTheMesh) {
  Mesh bowl = test::icosphere(5, 10, {});
  std::erase_if(bowl.triangles, [&](const Triangle& t) { return bowl.positions[t[0]].z < 0; });
  compactVertices(bowl);
  for (std::size_t v = 0; v < bowl.positions.size(); ++v) bowl.visibility.push_back(float(v));
  const Mesh few = decimateMesh(bowl, 1000);
  EXPECT_LE(few.triangles.size(), 1100u);
  ASSERT_EQ(few.normals.size(), few.positions.size());
  for (std::size_t v = 0; v < few.positions.size(); ++v) {
    const auto original = std::size_t(few.visibility[v]);
    EXPECT_EQ(few.positions[v], bowl.positions[original]);
    EXPECT_EQ(few.normals[v], bowl.normals[original]);
  }
  EXPECT_EQ(checkMesh(few).boundaryEdges, checkMesh(bowl).boundaryEdges);
  EXPECT_EQ(checkMesh(few).euler, 1);
}

TEST(Decimate, ThinPlatesStayManifold) {
  Mesh plate = test::icosphere(6, 10, {});
  for (glm::vec3& p : plate.positions) p.z *= 0.002f;
  const Mesh few = decimateMesh(plate, 300);
  const MeshCheck check = checkMesh(few);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_LT(few.triangles.size(), 5000u);
}

TEST(Decimate, EnoughIsLeftAlone) {
  const Mesh sphere = test::icosphere(3, 10, {});
  EXPECT_EQ(decimateMesh(sphere, 1280).triangles, sphere.triangles);
}

std::ptrdiff_t threads() { return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}); }

// However often it is cancelled: one call of the library at most goes on, and the next one waits for it.
TEST(Decimate, CancelledWhileTheLibraryWorks) {
  const Mesh sphere = test::icosphere(7, 10, {});
  decimateMesh(test::icosphere(4, 10, {}), 100);
  const std::ptrdiff_t before = threads();
  for (int i = 0; i < 6; ++i) {
    ProgressSink sink;
    int reports = 0;
    sink.report = [&](double) { sink.cancel = ++reports == 2; };  // the library is called after the second
    EXPECT_THROW(decimateMesh(sphere, 100, Progress(sink)), Cancelled);
    EXPECT_LE(threads(), before + 2);  // the one before may be just about to leave
  }
}

}  // namespace
}  // namespace sonoskin
