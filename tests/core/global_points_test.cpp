#include "core/rbf/global/global_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/expect_error.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

GlobalOptions offBy(double offset, double share = 1) {
  GlobalOptions options;
  options.offset = offset;
  options.offsetShare = share;
  return options;
}

TEST(GlobalPoints, LieOnBothSidesWithTheirDistances) {
  const SurfacePoints sphere = spherePoints(500, 20);
  const GlobalPoints points = makeGlobalPoints(sphere, offBy(1));
  EXPECT_EQ(points.onSurface, 500u);
  ASSERT_EQ(points.size(), 1500u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(glm::length(points.sites[i]) - 20, points.values[i], 1e-5);
    EXPECT_EQ(points.values[i] == 0, i < 500);
  }
}

TEST(GlobalPoints, AShareOfThemHasPointsOffTheSurface) {
  const SurfacePoints sphere = spherePoints(1000, 20);
  EXPECT_EQ(makeGlobalPoints(sphere, offBy(1, 0.5)).size(), 2000u);
  EXPECT_EQ(makeGlobalPoints(sphere, offBy(1, 0.1)).size(), 1200u);
}

// Two sheets a millimetre apart, facing away from each other: a point 0.8 mm below the upper one would be nearer to
// the lower one.
TEST(GlobalPoints, DoNotReachThroughAThinPart) {
  SurfacePoints sheets = planePoints(20);
  for (std::size_t i = 0, n = sheets.size(); i < n; ++i) {
    sheets.positions.push_back(sheets.positions[i] - glm::vec3(0, 0, 1));
    sheets.normals.push_back({0, 0, -1});
    sheets.confidence.push_back(1);
  }
  const GlobalPoints points = makeGlobalPoints(sheets, offBy(0.8));
  std::size_t inside = 0;
  for (std::size_t i = points.onSurface; i < points.size(); ++i) {
    const double z = points.sites.z[i];
    const bool isBetween = z < -1e-6 && z > -1 + 1e-6;
    EXPECT_EQ(points.values[i] < 0, isBetween) << z;
    if (!isBetween) continue;
    ++inside;
    EXPECT_NEAR(points.values[i], -0.4, 1e-6);  // halved once
    EXPECT_NEAR(std::min(-z, 1 + z), 0.4, 1e-6);
  }
  EXPECT_EQ(inside, 800u);
}

TEST(GlobalPoints, TheNearestPointOfTheSurfaceIsTheirOwn) {
  const SurfacePoints sphere = spherePoints(400, 5, 0.3);
  const GlobalPoints points = makeGlobalPoints(sphere, offBy(3));
  EXPECT_LT(*std::min_element(points.values.begin(), points.values.end()), -1);
  std::size_t halved = 0;
  for (std::size_t i = points.onSurface; i < points.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t k = 0; k < points.onSurface; ++k)
      nearest = std::min(nearest, glm::distance(points.sites[i], points.sites[k]));
    EXPECT_NEAR(nearest, std::abs(points.values[i]), 1e-9);
    halved += std::abs(points.values[i]) < 3;
  }
  EXPECT_GT(halved, 100u);
}

// Two points nearer to each other than the last halving of the distance, face to face.
TEST(GlobalPoints, AreLeftOutWhereNoDistanceIsRight) {
  SurfacePoints sheet = planePoints(10);
  sheet.positions.push_back(sheet.positions[37] + glm::vec3(0, 0, 1e-3f));
  sheet.normals.push_back({0, 0, -1});
  sheet.confidence.push_back(1);
  EXPECT_EQ(makeGlobalPoints(sheet, offBy(1)).size(), 301u);
}

TEST(GlobalPoints, EqualPointsCountOnce) {
  SurfacePoints sphere = spherePoints(100, 20);
  const std::size_t expected = makeGlobalPoints(sphere, offBy(1)).size();
  for (std::size_t i = 0; i < 100; i += 3) {
    sphere.positions.push_back(sphere.positions[i]);
    sphere.normals.push_back(sphere.normals[i]);
    sphere.confidence.push_back(1);
  }
  EXPECT_EQ(makeGlobalPoints(sphere, offBy(1)).size(), expected);
}

TEST(GlobalPoints, DoNotDependOnTheThreads) {
  const SurfacePoints sphere = spherePoints(2000, 5, 0.2);
  setThreadCount(1);
  const GlobalPoints one = makeGlobalPoints(sphere, offBy(2));
  setThreadCount(2);
  const GlobalPoints two = makeGlobalPoints(sphere, offBy(2));
  setThreadCount(0);
  EXPECT_EQ(one.sites.x, two.sites.x);
  EXPECT_EQ(one.values, two.values);
}

TEST(GlobalPoints, RefuseBadInput) {
  test::expectError([] { makeGlobalPoints(spherePoints(11, 5), {}); }, "at least 12");
  SurfacePoints line = spherePoints(50, 5), equal = line, infinite = line, blind = line;
  for (std::size_t i = 0; i < 50; ++i) {
    line.positions[i] = glm::vec3(float(i), 0, 0);
    equal.positions[i] = glm::vec3(1);
  }
  infinite.positions[7].y = std::numeric_limits<float>::quiet_NaN();
  blind.normals[8] = glm::vec3(0);
  test::expectError([&] { makeGlobalPoints(line, {}); }, "one line");
  test::expectError([&] { makeGlobalPoints(equal, {}); }, "one line");
  test::expectError([&] { makeGlobalPoints(infinite, {}); }, "finite");
  test::expectError([&] { makeGlobalPoints(blind, {}); }, "no normal");
}

TEST(GlobalPoints, CanBeCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(makeGlobalPoints(spherePoints(1000, 5), {}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
