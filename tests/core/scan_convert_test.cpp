#include "core/volume/scan_convert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

std::vector<double> evenly(int count, double first, double last) {
  std::vector<double> values;
  for (int n = 0; n < count; ++n) values.push_back(first + (last - first) * n / (count - 1));
  return values;
}

SweptGrid smallTorus() {
  SweptGrid g;
  g.samples = 60;
  g.firstRadius = 30;
  g.sampleDistance = 0.7;
  g.axisDepth = 12;
  g.fan = evenly(48, -0.5, 0.5);
  g.sweep = evenly(40, -0.45, 0.45);
  return g;
}

// Angles as a motor that runs up and slows down gives them.
SweptGrid unevenTorus() {
  SweptGrid g = smallTorus();
  for (double& t : g.fan) t = 0.5 * std::sin(glm::half_pi<double>() * t / 0.5);
  for (double& p : g.sweep) p = 0.42 * std::sin(glm::half_pi<double>() * p / 0.45) + 0.03;
  return g;
}

SweptGrid linearSweep() {
  SweptGrid g = smallTorus();
  g.parallel = true;
  g.fan = evenly(48, -20, 23);
  g.firstRadius = 9;
  g.axisDepth = -80;
  return g;
}

SweptGrid turnedTables(SweptGrid g) {
  std::reverse(g.fan.begin(), g.fan.end());
  std::reverse(g.sweep.begin(), g.sweep.end());
  return g;
}

PyramidGrid smallPyramid() {
  PyramidGrid g;
  g.dims = {40, 50, 12};
  g.lateral = 0.9;
  g.depth = 0.8;
  g.aperture = 10;
  g.growth = 0.5;
  return g;
}

std::vector<SampleGrid> grids() {
  return {smallTorus(), unevenTorus(), turnedTables(unevenTorus()), linearSweep(), smallPyramid()};
}

Volume<float> sampled(const SampleGrid& grid, const std::function<double(const glm::dvec3&)>& of) {
  Volume<float> samples(test::grid(gridDims(grid)));
  for (int k = 0; k < samples.geometry.dims.z; ++k)
    for (int j = 0; j < samples.geometry.dims.y; ++j)
      for (int i = 0; i < samples.geometry.dims.x; ++i)
        samples.at(i, j, k) = float(of(gridPlace(grid, {i, j, k})));
  return samples;
}

double smooth(const glm::dvec3& p) {
  return 0.5 + 0.2 * std::sin(p.x / 9) + 0.15 * std::cos(p.y / 8 + 1) + 0.1 * std::sin(p.z / 11 + 2);
}

// The same by the inverse of the whole grid, one voxel after another.
ConvertedScan convertPlainly(const SampleGrid& grid, const Volume<float>& samples, const Geometry& geometry) {
  ConvertedScan converted{Volume<float>(geometry), Volume<std::uint8_t>(geometry)};
  for (int k = 0; k < geometry.dims.z; ++k)
    for (int j = 0; j < geometry.dims.y; ++j)
      for (int i = 0; i < geometry.dims.x; ++i)
        if (const auto at = gridIndex(grid, geometry.toWorld({i, j, k}))) {
          double sum = 0;
          const glm::ivec3 low = glm::min(glm::ivec3(*at), gridDims(grid) - 2);
          for (int c = 0; c < 8; ++c) {
            const glm::ivec3 corner = low + glm::ivec3(c & 1, c >> 1 & 1, c >> 2);
            const glm::dvec3 part = 1.0 - glm::abs(*at - glm::dvec3(corner));
            sum += part.x * part.y * part.z * double(samples.at(corner.x, corner.y, corner.z));
          }
          converted.volume.at(i, j, k) = float(sum);
          converted.scanned.at(i, j, k) = 1;
        }
  return converted;
}

TEST(SampleGrid, FollowsTheFormulaOfATorus) {
  const SweptGrid g = smallTorus();
  const double r = 30 + 0.7 * 17, t = g.fan[11], p = g.sweep[33], rb = 12;
  const glm::dvec3 place = gridPlace(g, {17, 11, 33});
  EXPECT_NEAR(place.x, r * std::sin(t), 1e-12);
  EXPECT_NEAR(place.y, -(r * std::cos(t) - rb) * std::sin(p), 1e-12);
  EXPECT_NEAR(place.z, rb * (1 - std::cos(p)) + r * std::cos(t) * std::cos(p), 1e-12);
}

TEST(SampleGrid, FindsEverySampleAgain) {
  for (const SampleGrid& grid : grids()) {
    const glm::dvec3 last(gridDims(grid) - 1);
    for (std::uint64_t n = 0; n < 1000; ++n) {
      const glm::dvec3 index =
          last * glm::dvec3(test::noise(3 * n), test::noise(3 * n + 1), test::noise(3 * n + 2));
      const auto back = gridIndex(grid, gridPlace(grid, index));
      ASSERT_TRUE(back) << gridName(grid);
      EXPECT_LT(glm::distance(*back, index), 1e-10) << gridName(grid);
    }
  }
}

TEST(SampleGrid, EndsWhereNothingWasSampled) {
  const SweptGrid g = smallTorus();
  EXPECT_FALSE(gridIndex(g, {0, 0, 29.9}));
  EXPECT_TRUE(gridIndex(g, {0, 0, 30.1}));
  EXPECT_FALSE(gridIndex(g, {0, 0, -30.1}));
  EXPECT_FALSE(gridIndex(g, {0, 0, g.lastRadius() + 0.01}));
  EXPECT_FALSE(gridIndex(g, {50 * std::tan(0.501), 0, 50}));
  EXPECT_FALSE(gridIndex(g, {0, 40 * std::sin(0.451), 12 + 40 * std::cos(0.451)}));
  EXPECT_FALSE(gridIndex(smallPyramid(), {1, 1, 40}));
}

TEST(SampleGrid, RefusesWhatNoProbeCanBe) {
  SweptGrid g = smallTorus();
  EXPECT_FALSE(gridFault(g));
  g.fan[3] = g.fan[2];
  EXPECT_TRUE(gridFault(g));
  g = smallTorus();
  g.axisDepth = 29;  // behind the outermost beams' first samples, which would lie where others do
  EXPECT_TRUE(gridFault(g));
  g = smallTorus();
  g.sweep.back() = 1.7;
  EXPECT_TRUE(gridFault(g));
  g = smallTorus();
  g.sampleDistance = std::nan("");
  EXPECT_TRUE(gridFault(g));
  g = smallTorus();
  g.sweep[2] = std::nan("");
  EXPECT_TRUE(gridFault(g));
  g = smallTorus();
  for (double& t : g.fan) t *= 1e-9;
  EXPECT_TRUE(gridFault(g));
  PyramidGrid p = smallPyramid();
  EXPECT_FALSE(gridFault(p));
  p.growth = -0.5;
  EXPECT_TRUE(gridFault(p));
}

TEST(ConvertScan, GivesASmoothFunctionOfTheWorldBack) {
  for (const SampleGrid& grid : grids()) {
    const Geometry voxels = voxelsOf(grid, 0, 1e7);
    const ConvertedScan converted = convertScan(grid, sampled(grid, smooth), voxels);
    std::size_t scanned = 0;
    double worst = 0;
    for (int k = 0; k < voxels.dims.z; ++k)
      for (int j = 0; j < voxels.dims.y; ++j)
        for (int i = 0; i < voxels.dims.x; ++i)
          if (converted.scanned.at(i, j, k)) {
            ++scanned;
            worst = std::max(
                worst, std::abs(double(converted.volume.at(i, j, k)) - smooth(voxels.toWorld({i, j, k}))));
          }
    EXPECT_GT(double(scanned), 0.3 * double(voxels.voxels())) << gridName(grid);
    // A pyramid's outermost samples hold for half a cell, which for its pictures is 1.2 mm.
    EXPECT_LT(worst, std::holds_alternative<PyramidGrid>(grid) ? 0.03 : 0.003) << gridName(grid);
  }
}

TEST(ConvertScan, AgreesWithThePlainWay) {
  for (const SampleGrid& grid : grids()) {
    std::uint64_t n = 0;
    const Volume<float> samples = sampled(grid, [&](const glm::dvec3&) { return test::noise(n++); });
    for (const double edge : {0.0, 0.83}) {
      const Geometry voxels = voxelsOf(grid, edge, 1e7);
      const ConvertedScan plain = convertPlainly(grid, samples, voxels);
      const ConvertedScan converted = convertScan(grid, samples, voxels);
      std::size_t differing = 0;
      double worst = 0;
      for (std::size_t v = 0; v < voxels.voxels(); ++v) {
        if (plain.scanned.data[v] != converted.scanned.data[v])
          ++differing;  // on the very border, by rounding
        else
          worst = std::max(worst, std::abs(double(plain.volume.data[v] - converted.volume.data[v])));
      }
      EXPECT_LT(worst, 0.02) << gridName(grid);
      EXPECT_LT(double(differing), 1e-3 * double(voxels.voxels())) << gridName(grid);
    }
  }
}

TEST(ConvertScan, LetsNothingOutOfTheScannedPart) {
  for (const SampleGrid& grid : grids()) {
    const Geometry voxels = voxelsOf(grid, 0.6, 1e8);
    const ConvertedScan converted =
        convertScan(grid, sampled(grid, [](const glm::dvec3&) { return 1; }), voxels);
    std::size_t outside = 0;
    for (std::size_t v = 0; v < voxels.voxels(); ++v) {
      const float value = converted.volume.data[v];
      ASSERT_TRUE(converted.scanned.data[v] ? value > 0.9999f && value < 1.0001f : value == 0);
      outside += !converted.scanned.data[v];
    }
    EXPECT_GT(outside, 0u);
  }
}

TEST(VoxelsOf, HoldAllSamples) {
  for (const SampleGrid& grid : grids())
    for (const double edge : {0.0, 0.5, 2.0}) {
      const Geometry voxels = voxelsOf(grid, edge, 1e8);
      const glm::dvec3 last(gridDims(grid) - 1), end = glm::dvec3(voxels.dims - 1) + 1e-6;
      for (int c = 0; c < 27; ++c) {
        const glm::dvec3 at =
            voxels.toIndex(gridPlace(grid, last * glm::dvec3(c % 3, c / 3 % 3, c / 9) * 0.5));
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(at, glm::dvec3(-1e-6)))) << gridName(grid);
        EXPECT_TRUE(glm::all(glm::lessThanEqual(at, end))) << gridName(grid);
      }
    }
}

TEST(VoxelsOf, ArePlainForPyramidsAndRoundForFans) {
  const PyramidGrid pyramid = smallPyramid();
  const Geometry own = voxelsOf(pyramid, 0, 1e9);
  EXPECT_EQ(own.dims,
            glm::ivec3(40, 50, 36));  // 30 mm at the far end: 12 pictures 2.5 mm apart, three voxels each
  EXPECT_EQ(own.spacing, glm::dvec3(0.9, 0.8, 2.5 / 3));
  EXPECT_EQ(own.origin, glm::dvec3(0));
  const Geometry cubes = voxelsOf(smallTorus(), 0, 1e9);
  EXPECT_EQ(cubes.spacing.x, cubes.spacing.z);
  EXPECT_NEAR(cubes.spacing.x, 0.88,
              1e-9);  // 0.7 mm along the beams, 1.08 and 0.89 mm across them in the middle
}

TEST(VoxelsOf, GrowWhereThereAreTooMany) {
  for (const SampleGrid& grid : grids()) {
    const Geometry voxels = voxelsOf(grid, 0, 20000);
    EXPECT_LT(double(voxels.voxels()), 22000) << gridName(grid);
    EXPECT_GT(double(voxels.voxels()), 10000) << gridName(grid);
  }
}

TEST(GridBeam, StartsAtTheApex) {
  const auto beam = gridBeam(smallTorus());
  ASSERT_TRUE(beam);
  EXPECT_EQ(beam->axis, glm::dvec3(0, 0, 1));
  EXPECT_EQ(beam->apex, glm::dvec3(0));
  EXPECT_EQ(gridBeam(linearSweep())->apex, glm::dvec3(0, 0, -80));
  EXPECT_FALSE(gridBeam(smallPyramid()));
}

}  // namespace
}  // namespace sonoskin
