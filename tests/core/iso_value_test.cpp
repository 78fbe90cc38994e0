#include "core/classification/iso_value.h"

#include "core/classification/classification_options.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/io/volume_reader.h"
#include "core/phantom/phantom.h"
#include "core/volume/gaussian.h"
#include "tests/support/first_phantom.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

constexpr double kShare = 0.2;  // of the way from the fluid to the middle of the edge, as good as any

// A smooth step along j, the probe's axis, with its middle at j = at.
double step(double j, double at, double low, double high) {
  return low + (high - low) * 0.5 * (1 + std::tanh((j - at) / 2));
}

// A long beam, so that the flanks of the step weigh little beside fluid and tissue.
Geometry beamOfVoxels() { return test::grid({16, 200, 16}); }

TEST(IsoRange, GoesFromTheSmallestToTheLargestEdge) {
  GreyLevels levels{0.1f, 0.5f};
  EXPECT_NEAR(isoRangeOf(levels, 0.5).least, 0.3, 1e-6);
  EXPECT_NEAR(isoRangeOf(levels, 0.5).most, 0.3, 1e-6);
  auto field = std::make_shared<EdgeField>();
  field->grey = {0.7f, 0.3f, 0.5f};
  levels.edges = field;
  EXPECT_NEAR(isoRangeOf(levels, 0.5).least, 0.2, 1e-6);
  EXPECT_NEAR(isoRangeOf(levels, 0.5).most, 0.4, 1e-6);
  EXPECT_NEAR(isoRangeOf(levels, 0.5).fluid, 0.1, 1e-6);
}

TEST(IsoValue, LiesTheShareOfTheWayFromFluidToEdge) {
  const auto volume = test::fill(beamOfVoxels(), [](glm::dvec3 p) { return step(p.y, 100.5, 0.1, 0.8); });
  EXPECT_NEAR(proposeLevels(volume, {}, {}).between(kShare), 0.1 + kShare * 0.35, 0.01);
}

TEST(IsoValue, DoesNotDependOnHowMuchIsFluid) {
  for (const double border : {40.5, 100.5, 160.5}) {
    const auto volume = test::fill(beamOfVoxels(), [&](glm::dvec3 p) { return step(p.y, border, 0.3, 0.6); });
    EXPECT_NEAR(proposeLevels(volume, {}, {}).between(kShare), 0.3 + kShare * 0.15, 0.01) << border;
  }
}

TEST(IsoValue, IgnoresEdgesThatLookAway) {
  // Fluid, skin, and behind it tissue that grows brighter and ends in the dark: that end is steeper than the skin.
  const auto volume = test::fill(beamOfVoxels(), [](glm::dvec3 p) {
    return p.y > 150 ? 0.1 : step(p.y, 100.5, 0.1, 0.5) + 0.5 * std::clamp((p.y - 110) / 40, 0.0, 1.0);
  });
  EXPECT_NEAR(proposeLevels(volume, {}, {}).between(kShare), 0.1 + kShare * 0.2, 0.01);
}

TEST(IsoValue, DoesNotCountWhatLiesOutsideTheView) {
  const auto volume = test::fill(test::grid({60, 200, 16}), [](glm::dvec3 p) {
    return p.x < 30 ? 0.0 : step(p.y, 100.5, 0.4, 0.8);  // a black margin beside fluid and tissue
  });
  const FieldOfView view{{glm::vec4(-1, 0, 0, 29.5)}, {}};
  EXPECT_NEAR(proposeLevels(volume, view, {}).between(kShare), 0.4 + kShare * 0.2, 0.01);
}

TEST(IsoValue, OfAnEmptyVolumeIsInRange) {
  const float iso = proposeLevels(Volume<float>(test::grid({8, 8, 8})), {}, {}).between(0);
  EXPECT_GE(iso, 0.02f);
  EXPECT_LE(iso, 0.98f);
}

// A scanner that cuts the fluid off leaves it black: a lower level keeps faint skin, and no noise comes in.
TEST(IsoValue, LiesLowerWhereTheFluidIsBlack) {
  const auto levelsOf = [](double fluid) {
    return proposeLevels(
        test::fill(beamOfVoxels(), [&](glm::dvec3 p) { return step(p.y, 150.5, fluid, 0.8); }), {}, {});
  };
  const GreyLevels black = levelsOf(0), grey = levelsOf(0.1);
  EXPECT_GT(black.black, 0.9f);
  EXPECT_EQ(grey.black, 0.f);
  EXPECT_NEAR(grey.iso(0.6), grey.between(0.6), 1e-6);
  EXPECT_NEAR(black.iso(0.6), black.between(0.2), 1e-6);
  std::vector<float> row(16);
  black.isoRow(0.6, 150, 8, 16, row.data());
  EXPECT_NEAR(row[8], black.iso(0.6), 0.02);
}

// Skin that grows brighter along i: the level follows it, where that of the whole volume lies between.
TEST(IsoValue, FollowsTheEdgesAround) {
  const auto skin = [](double i) { return 0.3 + 0.5 * i / 119; };
  const auto volume =
      test::fill(test::grid({120, 80, 40}), [&](glm::dvec3 p) { return step(p.y, 40.5, 0.1, skin(p.x)); });
  const GreyLevels levels = proposeLevels(volume, {}, {});
  std::vector<float> row(120);
  levels.isoRow(1, 40, 20, 120, row.data());
  for (const int i : {15, 60, 104}) EXPECT_NEAR(row[std::size_t(i)], 0.5 * (0.1 + skin(i)), 0.03) << i;
}

// Far from all edges the level is that of the whole volume; with none at all it is the same everywhere.
TEST(IsoValue, IsThatOfTheWholeVolumeWhereThereAreNoEdges) {
  const auto volume = test::fill(test::grid({200, 40, 20}), [](glm::dvec3 p) {
    return p.x < 60 ? step(p.y, 20.5, 0.1, p.x < 30 ? 0.5 : 0.7) : 0.1;
  });
  const GreyLevels levels = proposeLevels(volume, {}, {});
  std::vector<float> row(200);
  levels.isoRow(1, 20, 10, 200, row.data());
  EXPECT_NEAR(row[195], levels.edge, 0.01);
  EXPECT_LT(row[5], row[50]);
  const GreyLevels flat = proposeLevels(Volume<float>(test::grid({20, 20, 20}), 0.2f), {}, {});
  flat.isoRow(0.6, 3, 3, 20, row.data());
  for (int i = 0; i < 20; ++i) EXPECT_EQ(row[std::size_t(i)], flat.iso(0.6));
}

// Bone shines brighter than the skin a centimetre before it, and does not count: no fluid lies before it.
TEST(IsoValue, FollowsTheSkinAndNotTheBoneBehindIt) {
  const auto volume = test::fill(test::grid({60, 80, 30}, {0.5, 0.5, 0.5}), [](glm::dvec3 p) {
    const double j = p.y / 0.5;
    return step(j, 30.5, 0.1, 0.5) + step(j, 46.5, 0, 0.4);
  });
  std::vector<float> row(60);
  proposeLevels(volume, {}, {}).isoRow(1, 30, 15, 60, row.data());
  EXPECT_NEAR(row[30], 0.3, 0.03);
}

// The mean greys of a simulated scan: fluid more than 3 mm clear of everything, and the skin that faces the probe.
struct Greys {
  double fluid = 0, skin = 0;
};

Greys trueGreys(const Scan& scan) {
  const Geometry& g = scan.volume->geometry;
  double sum[2]{}, count[2]{};
  for (int k = 0; k < g.dims.z; k += 2)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; i += 2) {
        const glm::dvec3 p = g.toWorld({i, j, k});
        const double value = double(scan.volume->at(i, j, k)), d = test::skinDistance(p);
        if (value <= 0) continue;
        const bool fluid = d > 3 && test::wallDistance(p) > 3, skin = d < 0 && d > -0.9 && p.y < 45;
        if (skin && test::skinDistance(p - 0.2 * scan.beam->directionAt(p)) - d < 0.14)
          continue;  // turned away
        if (!fluid && !skin) continue;
        sum[skin] += value, count[skin] += 1;
      }
  return {sum[0] / count[0], sum[1] / count[1]};
}

TEST(IsoValue, LiesJustAboveTheFluidAtAllNoiseLevels) {
  for (const double snr : {30.0, 20.0, 13.0, 8.0}) {
    PhantomOptions options;
    options.dims = {117, 64, 46};
    options.snr = snr;
    const Scan scan = makePhantomScan(options);
    const Volume<float> low = gaussianBlur(*scan.volume, 1.5);
    const float iso =
        proposeLevels(low, findFieldOfView(*scan.volume, *scan.beam), *scan.beam).between(kShare);
    const Greys greys = trueGreys(scan);
    const double share = (double(iso) - greys.fluid) / (greys.skin - greys.fluid);
    EXPECT_GT(share, 0.03) << "snr " << snr << ", fluid " << greys.fluid << ", skin " << greys.skin;
    EXPECT_LT(share, 0.3) << "snr " << snr << ", fluid " << greys.fluid << ", skin " << greys.skin;
  }
}

class IsoValueOfRealFace : public ::testing::TestWithParam<const char*> {};

TEST_P(IsoValueOfRealFace, IsNearTheOneThatAPersonChose) {
  const std::filesystem::path file = std::filesystem::path(SONOSKIN_SHARED_DATA) / "fetus" / GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const Scan scan = readScan(file);
  const Beam beam = beamOf(scan, {});
  const Volume<float> low = gaussianBlur(*scan.volume, 1.5);
  const double share = ClassificationOptions{}.isoShare;
  EXPECT_NEAR(proposeLevels(low, findFieldOfView(*scan.volume, beam), beam).between(share), 0.36, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Fetus, IsoValueOfRealFace,
                         ::testing::Values("fetus_00.nrrd", "fetus_03.nrrd", "fetus_06.nrrd",
                                           "fetus_09.nrrd"));

}  // namespace
}  // namespace sonoskin
