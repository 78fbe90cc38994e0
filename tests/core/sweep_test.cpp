#include "core/volume/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/volume/fill_gaps.h"
#include "tests/support/expect_error.h"

namespace sonoskin {
namespace {

// Planes that turn about an axis above them, as those of a probe that is tilted: pixels of 0.5 mm.
glm::dmat4 fanPose(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  glm::dmat4 pose(1);
  pose[0] = {0.5, 0, 0, 0};
  pose[1] = 0.5 * glm::dvec4(0, c, s, 0);
  pose[3] = {-20, 10 * c, 10 * s, 1};  // the first row lies 10 mm from the axis
  return pose;
}

// A sphere with a soft border.
double sphere(const glm::dvec3& world) {
  return 100 / (1 + std::exp(glm::distance(world, glm::dvec3(0, 30, 2)) - 9));
}

SweepFrames<float> fan(std::vector<float>& pixels, int frames) {
  SweepFrames<float> sweep{80, 80, {}, {}};
  for (int f = 0; f < frames; ++f) {
    sweep.poses.push_back(fanPose(-0.35 + 0.7 * f / (frames - 1)));
    for (int j = 0; j < 80; ++j)
      for (int i = 0; i < 80; ++i)
        pixels.push_back(float(sphere(glm::dvec3(sweep.poses.back() * glm::dvec4(i, j, 0, 1)))));
  }
  sweep.pixels = pixels;
  return sweep;
}

TEST(Sweep, ASphereCutByAFanOfPlanesIsThatSphere) {
  std::vector<float> pixels;
  const SweptVolume swept = reconstructSweep(fan(pixels, 60));
  const Geometry& g = swept.volume.geometry;
  double squares = 0, worst = 0;
  std::size_t covered = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        if (!swept.mask.at(i, j, k)) continue;
        const double error = swept.volume.at(i, j, k) - sphere(g.toWorld({i, j, k}));
        squares += error * error, worst = std::max(worst, std::abs(error));
        ++covered;
      }
  EXPECT_GT(covered, 250'000u);
  EXPECT_LT(std::sqrt(squares / double(covered)), 1.0);
  EXPECT_LT(worst, 25);  // across a border of 25 a millimetre
}

TEST(Sweep, TheMaskIsTheFanAndNothingElse) {
  std::vector<float> pixels;
  const SweptVolume swept = reconstructSweep(fan(pixels, 60));
  const Geometry& g = swept.volume.geometry;
  std::size_t wrong = 0, all = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 2; i < g.dims.x - 2; ++i, ++all) {
        const glm::dvec3 world = g.toWorld({i, j, k});
        const double radius = std::hypot(world.y, world.z), angle = std::abs(std::atan2(world.z, world.y));
        const double inside = std::min({(0.35 - angle) * radius, radius - 10, 49.5 - radius});  // mm
        if (inside > 1) wrong += !swept.mask.at(i, j, k);
        if (inside < -1.5) wrong += swept.mask.at(i, j, k) != 0;
      }
  EXPECT_LT(double(wrong), 0.005 * double(all));
}

// Every pixel asked of every voxel, in double.
void expectBruteForce(const SweepFrames<float>& sweep, const SweptVolume& swept) {
  const Geometry& g = swept.volume.geometry;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        double sum = 0, weights = 0;
        for (std::size_t p = 0; p < sweep.pixels.size(); ++p) {
          const std::size_t row = p / std::size_t(sweep.width), f = row / std::size_t(sweep.height);
          const glm::dvec4 pixel(double(p % std::size_t(sweep.width)),
                                 double(row % std::size_t(sweep.height)), 0, 1);
          const glm::dvec3 apart =
              1.0 - glm::abs(g.toIndex(glm::dvec3(sweep.poses[f] * pixel)) - glm::dvec3(i, j, k));
          if (apart.x <= 0 || apart.y <= 0 || apart.z <= 0) continue;
          sum += apart.x * apart.y * apart.z * sweep.pixels[p], weights += apart.x * apart.y * apart.z;
        }
        if (weights < 1e-3) continue;
        ASSERT_NEAR(swept.volume.at(i, j, k), sum / weights, 0.01) << i << " " << j << " " << k;
        ASSERT_TRUE(swept.mask.at(i, j, k));
      }
}

TEST(Sweep, LinearWeightsAreThoseOfBruteForce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  SweepFrames<float> sweep{9, 7, {}, {}};
  std::vector<float> pixels(9 * 7 * 5);
  for (float& p : pixels) p = float(number(random));
  sweep.pixels = pixels;
  for (int f = 0; f < 5; ++f) {
    const double a = 0.2 * number(random), b = 0.3 * number(random);
    glm::dmat4 pose(1);
    pose[0] = 0.7 * glm::dvec4(std::cos(a), std::sin(a), 0.0, 0.0);
    pose[1] = 0.9 * glm::dvec4(-std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b), 0.0);
    pose[3] = {number(random), number(random), f, 1};
    sweep.poses.push_back(pose);
  }
  expectBruteForce(sweep, reconstructSweep(sweep));
}

TEST(Sweep, GapsAreFilledBetweenPicturesAndNowhereElse) {
  Geometry g;
  g.dims = {12, 10, 14};
  Volume<float> volume(g);
  Volume<std::uint8_t> mask(g);
  const auto value = [](int i, int k) { return float(10 + i + 2 * k); };
  for (const int k : {3, 8})
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 12; ++i) volume.at(i, j, k) = value(i, k), mask.at(i, j, k) = 255;
  fillGaps(3, volume, mask);
  for (int k = 0; k < 14; ++k) {
    EXPECT_EQ(mask.at(5, 5, k) != 0, k >= 3 && k <= 8) << k;
    if (k > 3 && k < 8) {
      EXPECT_GT(volume.at(5, 5, k), value(5, 3) - 0.5f) << k;
      EXPECT_LT(volume.at(5, 5, k), value(5, 8) + 0.5f) << k;
    } else if (k < 3 || k > 8) {
      EXPECT_EQ(volume.at(5, 5, k), 0) << k;
    }
  }
  EXPECT_EQ(volume.at(5, 5, 3), value(5, 3));
}

TEST(Sweep, RefusesWhatIsNone) {
  std::vector<float> pixels(16, 1.f);
  SweepFrames<float> sweep{2, 2, pixels, {glm::dmat4(1)}};
  test::expectError([&] { reconstructSweep(sweep); }, "two are needed");
  sweep.poses.assign(4, glm::dmat4(1));
  sweep.poses[2][1] = sweep.poses[2][0];
  test::expectError([&] { reconstructSweep(sweep); }, "calibrate");
  sweep.poses[2] = glm::dmat4(1);
  sweep.poses[3][3] = {1e9, 0, 0,
                       1};  // a box that is long and thin has no fewer voxels where these are larger
  test::expectError([&] { reconstructSweep(sweep); }, "more than fit into memory");
  sweep.poses.pop_back();
  test::expectError([&] { reconstructSweep(sweep); }, "fewer pixels");
}

}  // namespace
}  // namespace sonoskin
