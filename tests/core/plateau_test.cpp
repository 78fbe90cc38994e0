// Laws of the whole way from a volume to points, on echoes that saturate and on recordings that are cut obliquely.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/base/parallel.h"
#include "core/pipeline/pipeline.h"
#include "core/surface/clusters.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

Scan scanOf(Volume<float> volume) {
  Scan scan;
  scan.key = scanKey(volume, {});
  scan.volume = std::make_shared<const Volume<float>>(std::move(volume));
  return scan;
}

std::vector<SurfaceVoxel> voxelsOf(const Volume<std::uint8_t>& thinned) {
  std::vector<SurfaceVoxel> voxels;
  const glm::ivec3 dims = thinned.geometry.dims;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        if (thinned.at(i, j, k)) voxels.push_back({{i, j, k}, {i, j, k}, 1});
  return voxels;
}

// How a saturated ball looks: black fluid, white where the echo saturates, and dark again in the shadow or not.
struct Plateau {
  double isoValue, lowPass;
  double thickness;  // mm of white before the shadow
};

class SaturatedBall : public testing::TestWithParam<Plateau> {
 protected:
  static constexpr double kRadius = 13;
  const glm::dvec3 centre{24.3, 26.1, 23.8};

  // Specks in the corners tell that all of the volume was scanned.
  Scan scan() const {
    const Plateau plateau = GetParam();
    return scanOf(test::fill(test::grid({50, 50, 50}), [&](glm::dvec3 p) {
      const double inward = kRadius - glm::distance(p, centre);
      const double speck = glm::all(glm::greaterThan(glm::abs(p - 24.5), glm::dvec3(24))) ? 0.02 : 0;
      const bool shadow = inward > plateau.thickness || p.y > centre.y + 2;
      return std::clamp(shadow ? 0.0 : 1.5 * inward + 0.5, speck, 1.0);
    }));
  }
};

// Every beam that meets the ball well meets exactly one sheet, and the sheet is one piece.
TEST_P(SaturatedBall, GivesOneClosedSheetTowardTheProbe) {
  Parameters p;
  p.classification.isoValue = GetParam().isoValue;
  p.classification.lowPass = GetParam().lowPass;
  const Results r = Pipeline().run(scan(), p, Goal::points);
  const auto voxels = voxelsOf(*r.thinned);
  const auto labels = labelClusters(voxels, r.thinned->geometry.dims);
  for (const int label : labels) EXPECT_EQ(label, 0);
  int holes = 0, doubles = 0, beams = 0;
  for (int k = 0; k < 50; ++k)
    for (int i = 0; i < 50; ++i) {
      if (std::hypot(i - centre.x, k - centre.z) > 0.85 * kRadius) continue;
      int last = -10, sheets = 0;
      for (int j = 0; j < 50; ++j) {
        if (!r.thinned->at(i, j, k)) continue;
        sheets += j > last + 2;
        last = j;
      }
      ++beams, holes += sheets == 0, doubles += sheets > 1;
    }
  EXPECT_GT(beams, 350);
  EXPECT_EQ(holes, 0);
  EXPECT_EQ(doubles, 0);
}

INSTANTIATE_TEST_SUITE_P(, SaturatedBall,
                         testing::Values(Plateau{0, 1.5, 100}, Plateau{0.25, 1.5, 100}, Plateau{0.25, 1.5, 5},
                                         Plateau{0.6, 1.5, 5}, Plateau{0.25, 0.8, 5}, Plateau{0.4, 2.5, 8}));

// A sector whose one side is oblique cuts through tissue. The skin before the cut is found, the cut is not.
TEST(ObliqueCut, IsNoSurface) {
  const double slope = std::tan(0.5);
  const auto inSector = [&](const glm::dvec3& p) {
    return p.x > 20 - slope * p.y && p.x < 55 && std::abs(p.z - 25) < 14 + 0.3 * p.y;
  };
  const auto volume = test::fill(test::grid({60, 60, 50}), [&](glm::dvec3 p) {
    const double skin = 22 + 0.15 * p.x;  // tissue fills everything below, to all sides of the sector
    return inSector(p) && p.y > skin ? 0.9 : 0.0;
  });
  const Results r = Pipeline().run(scanOf(volume), {}, Goal::points);
  ASSERT_GT(r.points->size(), 600u);
  for (const glm::vec3& p : r.points->positions) {
    EXPECT_NEAR(double(p.y), 22 + 0.15 * double(p.x), 2);
    const double toCut = (double(p.x) - 20 + slope * double(p.y)) * std::cos(0.5);
    EXPECT_GT(toCut, 2.5);
    EXPECT_LT(std::abs(double(p.z) - 25), 14 + 0.3 * double(p.y) - 2.5);
  }
}

TEST(SurfaceOfAVolume, DoesNotDependOnTheNumberOfThreads) {
  const Scan scan =
      scanOf(test::speckledSphere(test::grid({48, 44, 40}, {0.4, 0.4, 0.6}), {9.5, 9, 12}, 5.5, 0.4));
  const auto runWith = [&](int threads) {
    setThreadCount(threads);
    const Results r = Pipeline().run(scan, {}, Goal::points);
    setThreadCount(0);
    return r;
  };
  const Results one = runWith(1), three = runWith(3);
  ASSERT_GT(one.points->size(), 100u);
  EXPECT_EQ(one.points->positions, three.points->positions);
  EXPECT_EQ(one.points->normals, three.points->normals);
  EXPECT_EQ(one.points->confidence, three.points->confidence);
  EXPECT_EQ(one.thinned->data, three.thinned->data);
  EXPECT_EQ(one.points->noise, three.points->noise);
}

}  // namespace
}  // namespace sonoskin
