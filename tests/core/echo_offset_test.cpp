#include "core/surface/echo_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/phantom/fetal_face.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

constexpr double kSphere = 10;  // mm

// Points `outside` mm beyond a sphere, in a turned frame.
struct Ball {
  Geometry geometry = test::grid({60, 60, 40}, {0.5, 0.5, 0.75});
  glm::dvec3 centre;
  SurfacePoints points;

  explicit Ball(double outside) {
    geometry.origin = {5, -3, 7};
    geometry.direction = glm::dmat3(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
    centre = geometry.toWorld(0.5 * glm::dvec3(geometry.dims - 1));
    for (int n = 0; n < 3000; ++n) {
      const double z = 2 * test::noise(std::uint64_t(n)) - 1,
                   phi = 6.2831853 * test::noise(std::uint64_t(n) + 7777);
      const glm::dvec3 d(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
      points.positions.emplace_back(centre + (kSphere + outside) * d);
      points.normals.emplace_back(d);
      points.confidence.push_back(1);
    }
  }
  // volume: grey by the distance from the sphere, positive outside.
  template <class Grey>
  Volume<float> volume(const Grey& grey) const {
    return test::fill(geometry, [&](glm::dvec3 p) { return grey(glm::distance(p, centre) - kSphere); });
  }
};

// An echo that rises evenly over 4 mm, to its maximum 1 mm inside, and then falls to tissue.
double echo(double d) {
  if (d > 3) return 0.1;
  return d > -1 ? 0.1 + 0.2 * (3 - d) : std::max(0.5, 0.9 + 0.1 * (d + 1));
}

TEST(EchoOffset, IsTheWayToWhereTheGreyHasRisen) {
  const Ball ball(1.3);
  // 82 % of the rise from 0.1 to 0.9 is at 3 - 0.82 * 4 = -0.28 mm; the voxels cut the maximum a little.
  EXPECT_NEAR(echoOffset(ball.points, ball.volume(echo)), 1.3 + 0.28, 0.15);
}

TEST(EchoOffset, HoldsForNoiseAndSaturation) {
  const Ball ball(1.3);
  std::uint64_t n = 0;
  const auto noisy = ball.volume([&](double d) { return echo(d) + 0.4 * (test::noise(n++) - 0.5); });
  EXPECT_NEAR(echoOffset(ball.points, noisy), 1.58, 0.15);
  const auto saturated =
      ball.volume([](double d) { return std::min(1.0, 0.1 + 0.45 * std::max(0.0, 3 - d)); });
  EXPECT_NEAR(echoOffset(ball.points, saturated), 1.3 - (3 - 0.82 * 2), 0.2);
}

TEST(EchoOffset, IsZeroWhereNothingRises) {
  const Ball ball(0.5);
  EXPECT_EQ(echoOffset(ball.points, ball.volume([](double) { return 0.4; })), 0);
  EXPECT_EQ(echoOffset(ball.points, ball.volume([](double d) { return d > 0 ? 0.6 : 0.2; })), 0);
  EXPECT_EQ(echoOffset({}, ball.volume(echo)), 0);
}

TEST(EchoOffset, MovesAgainstTheNormals) {
  Ball ball(1);
  moveInward(ball.points, 1);
  for (const glm::vec3& p : ball.points.positions)
    EXPECT_NEAR(glm::distance(glm::dvec3(p), ball.centre), kSphere, 1e-4);
}

TEST(EchoOffset, StopsWhenCancelled) {
  const Ball ball(1);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(echoOffset(ball.points, ball.volume(echo), Progress(sink)), Cancelled);
}

// The median distance of the points from the true skin, mm, positive outside.
double medianDistance(const Results& results) {
  std::vector<double> distances;
  for (const glm::vec3& p : results.points->positions)
    if (const double d = skinDistance(glm::dvec3(p)); std::abs(d) < 2.5) distances.push_back(d);
  EXPECT_GT(distances.size(), 1000u);
  const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

// The points of a simulated scan lie on its true skin, whatever the iso-value, the low-pass and the noise; without the
// correction they lie outside of it.
TEST(EchoOffset, BringsThePointsOntoThePhantomsSkin) {
  struct Case {
    double snr, iso, lowPass;
  };
  for (const Case c : {Case{20, 0, 1.5}, Case{20, 0.4, 1}, Case{13, 0, 2}}) {
    Parameters p;
    p.phantom.dims = {156, 85, 41};
    p.phantom.snr = c.snr;
    p.classification.isoValue = c.iso;
    p.classification.lowPass = c.lowPass;
    const Scan scan = makePhantomScan(p.phantom);
    Pipeline pipeline;
    const Results on = pipeline.run(scan, p, Goal::points);
    p.surface.offsetCorrection = false;
    const Results off = pipeline.run(scan, p, Goal::points);
    EXPECT_GT(medianDistance(off), 0.1);
    EXPECT_EQ(off.echoOffset, 0);
    EXPECT_GT(on.echoOffset, 0.2);
    EXPECT_NEAR(medianDistance(on), 0, 0.25)
        << c.snr << " " << c.iso << " " << c.lowPass;  // voxels of 0.9 mm
  }
}

}  // namespace
}  // namespace sonoskin
