#include "core/phantom/distance_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace sonoskin {
namespace {

using glm::dvec3;

double ball(const dvec3& p) { return glm::distance(p, dvec3(9, 8, 7)) - 5; }
double slope(const dvec3& p) { return 0.5 * p.x - 0.25 * p.y + 0.75 * p.z - 1; }

Geometry grid() { return {{37, 33, 30}, dvec3(0.5), dvec3(-0.5, 0, 0.25), glm::dmat3(1)}; }

TEST(DistanceGrid, IsExactInTheBandAndKeepsTheSignElsewhere) {
  const Volume<float> v = sampleDistance(grid(), ball, 1.5);
  int far = 0;
  for (int k = 0; k < v.geometry.dims.z; ++k)
    for (int j = 0; j < v.geometry.dims.y; ++j)
      for (int i = 0; i < v.geometry.dims.x; ++i) {
        const double exact = ball(v.geometry.toWorld({i, j, k}));
        if (std::abs(exact) <= 1.5) {
          ASSERT_NEAR(v.at(i, j, k), exact, 1e-5);
        } else {
          ASSERT_GT(v.at(i, j, k) * exact, 0);
          ASSERT_GT(std::abs(v.at(i, j, k)), 1.5);
          far += std::abs(v.at(i, j, k) - exact) > 1e-4;
        }
      }
  EXPECT_GT(far, 1000) << "blocks off the surface should not be evaluated node by node";
}

TEST(DistanceGrid, InterpolatesAPlaneWithoutError) {
  const DistanceGrid g(sampleDistance(grid(), slope, 100));
  const glm::vec3 p(3.13f, 7.77f, 5.2f);
  const DistanceSample s = g.sample(p);
  EXPECT_NEAR(s.value, slope(dvec3(p)), 1e-5);
  EXPECT_NEAR(g.value(p), slope(dvec3(p)), 1e-5);
  EXPECT_NEAR(glm::distance(s.gradient, glm::vec3(0.5, -0.25, 0.75)), 0, 1e-4);
}

TEST(DistanceGrid, ClampsAtTheBorder) {
  const DistanceGrid g(sampleDistance(grid(), slope, 100));
  EXPECT_NEAR(g.value({-50, 3, 4}), g.value({-0.5f, 3, 4}), 1e-5);
}

TEST(DistanceGrid, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(sampleDistance(grid(), ball, 1, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
