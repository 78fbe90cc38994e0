#include "core/surface/surface_points.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A ramp in a frame that is turned, mirrored and shifted: brighter along world +z.
TEST(SurfacePoints, AreInTheWorldWithNormalsTowardTheDark) {
  Geometry g = test::grid({10, 10, 10}, {0.5, 0.7, 1.1});
  g.origin = {3, -2, 5};
  g.direction = glm::dmat3(glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0));
  const auto ramp = test::fill(g, [](glm::dvec3 p) { return 0.02 * p.z; });
  const std::vector<SurfaceVoxel> voxels{{{4, 5, 6}, {4.25f, 5, 6}, 0.8f}, {{7, 2, 3}, {7, 2.5f, 3}, 0.4f}};
  const SurfacePoints points = extractSurfacePoints(voxels, ramp);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(points.positions[0].z, 5 + 4.25 * 0.5, 1e-5);
  EXPECT_NEAR(points.positions[0].x, 3 + 6 * 1.1, 1e-5);
  for (const auto& n : points.normals) EXPECT_NEAR(glm::length(n - glm::vec3(0, 0, -1)), 0, 1e-4);
  EXPECT_FLOAT_EQ(points.confidence[1], 0.4f);
}

TEST(SurfacePoints, WithoutGradientAreLeftOut) {
  const Volume<float> flat(test::grid({8, 8, 8}), 0.5f);
  EXPECT_EQ(extractSurfacePoints({{{4, 4, 4}, {4, 4, 4}, 1.0f}}, flat).size(), 0u);
}

TEST(SurfacePoints, ThinnedVolumeHoldsTheirValues) {
  const auto volume =
      thinnedVolume({{{1, 2, 3}, {1, 2, 3}, 0.5f}, {{4, 4, 4}, {4, 4, 4}, 0.001f}}, test::grid({6, 6, 6}));
  EXPECT_EQ(volume.at(1, 2, 3), 128);
  EXPECT_EQ(volume.at(4, 4, 4), 1);
  EXPECT_EQ(volume.at(0, 0, 0), 0);
}

TEST(SurfacePoints, StopsWhenCancelled) {
  const Volume<float> flat(test::grid({8, 8, 8}), 0.5f);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(extractSurfacePoints({{{4, 4, 4}, {4, 4, 4}, 1.0f}}, flat, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
