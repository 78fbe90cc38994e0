#include "core/surface/edge_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/first_phantom.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

constexpr double kSphere = 10;  // mm

// Points around a sphere, `outside` mm beyond it and up to `scatter` farther or nearer, in a turned frame.
struct Ball {
  Geometry geometry = test::grid({60, 60, 40}, {0.5, 0.5, 0.75});
  glm::dvec3 centre;
  SurfacePoints points;

  explicit Ball(double outside, double scatter = 0) {
    geometry.origin = {5, -3, 7};
    geometry.direction = glm::dmat3(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
    centre = geometry.toWorld(0.5 * glm::dvec3(geometry.dims - 1));
    for (int n = 0; n < 3000; ++n) {
      const double z = 2 * test::noise(std::uint64_t(n)) - 1,
                   phi = 6.2831853 * test::noise(std::uint64_t(n) + 7777);
      const glm::dvec3 d(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
      const double radius = kSphere + outside + scatter * (2 * test::noise(std::uint64_t(n) + 99999) - 1);
      points.positions.emplace_back(centre + radius * d);
      points.normals.emplace_back(d);
      points.confidence.push_back(1);
    }
  }
  // volume: grey by the distance from the sphere, positive outside.
  template <class Grey>
  Volume<float> volume(const Grey& grey) const {
    return test::fill(geometry, [&](glm::dvec3 p) { return grey(glm::distance(p, centre) - kSphere); });
  }
  // The distances of the points from the sphere, ascending.
  std::vector<double> distances() const {
    std::vector<double> all;
    for (const glm::vec3& p : points.positions) all.push_back(glm::distance(glm::dvec3(p), centre) - kSphere);
    std::ranges::sort(all);
    return all;
  }
};

// An edge of a Gaussian's integral, whose steepest rise lies on the sphere: 20 to 80 % take 1.68 sigma.
constexpr double kSigma = 0.8;
double edge(double d) { return 0.1 + 0.35 * (1 - std::erf(d / (kSigma * std::sqrt(2)))); }

TEST(EdgePlacement, MovesPointsToTheSteepestRise) {
  Ball ball(1.2);
  const EdgeProfile profile = placeOnEdges(ball.points, ball.volume(edge), 0);
  const std::vector<double> d = ball.distances();
  EXPECT_NEAR(d[d.size() / 2], 0, 0.05);
  EXPECT_LT(d[d.size() * 95 / 100] - d[d.size() * 5 / 100], 0.12);
  EXPECT_NEAR(profile.shift, 1.2, 0.05);
  EXPECT_NEAR(profile.dark, 0.1, 0.02);
  EXPECT_NEAR(profile.bright, 0.8, 0.02);
  EXPECT_NEAR(profile.steepest, 0.45, 0.04);
  EXPECT_NEAR(profile.width, 1.68 * kSigma, 0.15);
}

TEST(EdgePlacement, EachPointFindsItsOwnWay) {
  Ball ball(0.6, 0.5);
  placeOnEdges(ball.points, ball.volume(edge), 0);
  const std::vector<double> d = ball.distances();
  EXPECT_LT(d[d.size() * 95 / 100] - d[d.size() * 5 / 100], 0.25);  // of 0.9 mm before
}

TEST(EdgePlacement, TheSkinLiesBehindTheRiseByAShareOfItsWidth) {
  Ball ball(1);
  const EdgeProfile profile = placeOnEdges(ball.points, ball.volume(edge), 0.5);
  const std::vector<double> d = ball.distances();
  EXPECT_NEAR(profile.depth, 0.5 * profile.width, 1e-9);
  EXPECT_NEAR(d[d.size() / 2], -profile.depth, 0.05);
}

// Bone behind the skin rises higher and steeper, and does not draw the points to it.
TEST(EdgePlacement, StaysOnTheSkinBeforeBone) {
  Ball ball(0.8);
  const auto grey = [](double d) { return edge(d) * 0.5 + 0.3 * (1 - std::erf((d + 4) / 0.7)); };
  placeOnEdges(ball.points, ball.volume(grey), 0);
  const std::vector<double> d = ball.distances();
  EXPECT_NEAR(d[d.size() / 2], 0, 0.1);
  EXPECT_GT(d[d.size() / 100], -1);
}

TEST(EdgePlacement, MeasuresMoreNoiseWhereThereIsMore) {
  std::uint64_t n = 0;
  const auto noiseOf = [&](double noise) {
    Ball ball(0.5);
    placeOnEdges(ball.points,
                 ball.volume([&](double d) { return edge(d) + noise * (test::noise(n++) - 0.5); }), 0);
    std::vector<float> sorted = ball.points.noise;
    std::ranges::sort(sorted);
    return double(sorted[sorted.size() / 2]);
  };
  const double little = noiseOf(0.1), much = noiseOf(0.4);
  EXPECT_LT(noiseOf(0), 0.03);
  EXPECT_GT(little, 0.02);
  EXPECT_NEAR(much / little, 4, 1.5);  // the place of a maximum moves as the noise does
}

TEST(EdgePlacement, LeavesPointsWhereNothingRises) {
  for (const auto& grey : {+[](double) { return 0.4; }, +[](double d) { return d > 0 ? 0.6 : 0.2; }}) {
    Ball ball(0.5);
    const std::vector<glm::vec3> before = ball.points.positions;
    EXPECT_EQ(placeOnEdges(ball.points, ball.volume(grey), 0.5).width, 0);
    EXPECT_EQ(ball.points.positions, before);
    EXPECT_TRUE(ball.points.noise.empty());
  }
  SurfacePoints none;
  EXPECT_EQ(placeOnEdges(none, Ball(0).volume(edge), 0.5).width, 0);
}

TEST(EdgePlacement, StopsWhenCancelled) {
  Ball ball(1);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(placeOnEdges(ball.points, ball.volume(edge), 0.5, Progress(sink)), Cancelled);
}

// The median distance of the points from the true skin, mm, positive outside.
double medianDistance(const Results& results) {
  std::vector<double> distances;
  for (const glm::vec3& p : results.points->positions)
    if (const double d = test::skinDistance(glm::dvec3(p)); std::abs(d) < 2.5) distances.push_back(d);
  EXPECT_GT(distances.size(), 1000u);
  const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

// The points of a simulated scan lie on its true skin, whatever the iso-value, the low-pass and the noise.
TEST(EdgePlacement, BringsThePointsOntoThePhantomsSkin) {
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
    EXPECT_EQ(off.edge.width, 0);
    EXPECT_GT(on.edge.depth, 0.2);
    EXPECT_NEAR(medianDistance(on), 0, 0.25)
        << c.snr << " " << c.iso << " " << c.lowPass;  // voxels of 0.9 x 0.9 x 2.7 mm
  }
}

}  // namespace
}  // namespace sonoskin
