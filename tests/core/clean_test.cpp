#include "core/mesh/repair/clean.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/half_edges.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

TEST(Clean, OnlyHolesAreClosedByDefault) {
  EXPECT_TRUE(needsCleaning({}));
  MeshOptions options;
  options.fillHoles = 0;
  EXPECT_FALSE(needsCleaning(options));
  options.smoothing = 1;
  EXPECT_TRUE(needsCleaning(options));
}

TEST(Clean, SmallPiecesGoAndTheLargestStays) {
  const Mesh all = joinPieces(
      {test::icosphere(3, 10, {}), test::icosphere(2, 1, {20, 0, 0}), test::icosphere(2, 3, {-20, 0, 0})});
  MeshOptions options;
  options.minArea = 50;
  EXPECT_EQ(splitPieces(cleanMesh(all, options)).size(), 2u);
  options.minArea = 1e6;
  EXPECT_EQ(splitPieces(cleanMesh(all, options)).size(), 1u);
}

TEST(Clean, EverythingTogether) {
  Mesh mesh = test::icosphere(5, 10, {});
  mesh.triangles.erase(mesh.triangles.begin() + 100, mesh.triangles.begin() + 104);
  mesh.visibility.assign(mesh.positions.size(), 1.f);
  compactVertices(mesh);
  MeshOptions options;
  options.minArea = 1;
  options.fillHoles = 3;
  options.smoothing = 3;
  options.triangles = 4000;
  const Mesh clean = cleanMesh(mesh, options);
  const MeshCheck check = checkMesh(clean);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_LE(clean.triangles.size(), 4100u);
  EXPECT_EQ(clean.visibility.size(), clean.positions.size());
  EXPECT_EQ(clean.normals.size(), clean.positions.size());
}

Mesh withoutCap(float height) {
  Mesh mesh = test::icosphere(5, 10, {});
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.positions[v].z > height; });
  });
  compactVertices(mesh);
  mesh.measured.assign(mesh.positions.size(), 1.f);
  return mesh;
}

TEST(Clean, AHoleIsClosedAndMarkedAndAnOutlineStaysOpen) {
  const Mesh open = withoutCap(9.4f);  // a hole of 7 mm across
  const Mesh closed = cleanMesh(open, {});
  EXPECT_TRUE(checkMesh(closed).closed());
  ASSERT_EQ(closed.measured.size(), closed.positions.size());
  for (std::size_t v = 0; v < closed.positions.size(); ++v) {
    ASSERT_EQ(closed.measured[v], v < open.positions.size() ? 1.f : 0.f);
    ASSERT_NEAR(glm::length(closed.positions[v]), 10, 0.05);
  }
  const Mesh cap = withoutCap(-9.4f);  // a patch of 7 mm across, all outline
  ASSERT_FALSE(cap.empty());
  EXPECT_EQ(cleanMesh(cap, {}).triangles.size(), cap.triangles.size());
}

TEST(Clean, Cancelled) {
  MeshOptions options;
  options.fillHoles = 3;
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(cleanMesh(test::icosphere(2, 1, {}), options, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
