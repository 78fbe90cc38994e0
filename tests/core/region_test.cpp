#include "core/surface/region.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/test_volumes.h"
#include "tests/support/volumes.h"

namespace sonoskin {
namespace {

Scan turnedScan(bool mirrored = false) {
  Geometry g = test::turnedGeometry(mirrored);
  g.dims = {20, 16, 10};
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(test::filledVolume<float>(g));
  return scan;
}

// The cuts are along the volume's own axes, however it lies in the world.
TEST(Region, TheBoxFollowsTheAxesOfATurnedVolume) {
  for (const bool mirrored : {false, true}) {
    const Scan scan = turnedScan(mirrored);
    const Geometry& g = scan.volume->geometry;
    const RegionOptions options{{1.3, 0, 2.5}, {0, 3.1, 1.25}};
    const Region region = regionOf(scan, options);
    for (int k = 0; k < g.dims.z; ++k)
      for (int j = 0; j < g.dims.y; ++j)
        for (int i = 0; i < g.dims.x; ++i) {
          const glm::dvec3 low = glm::transpose(g.direction) * (g.toWorld({i, j, k}) - g.origin),
                           high = g.spacing * glm::dvec3(g.dims - 1) - low;
          bool inside = true;
          for (int axis = 0; axis < 3; ++axis)
            inside = inside && low[axis] > options.cutLow[std::size_t(axis)] - 1e-6 &&
                     high[axis] > options.cutHigh[std::size_t(axis)] - 1e-6;
          EXPECT_EQ(region.contains({i, j, k}), inside) << i << " " << j << " " << k;
        }
  }
}

TEST(Region, NothingCutIsTheWholeVolume) {
  Scan scan = turnedScan();
  const Region whole = regionOf(scan, {});
  EXPECT_TRUE(isWhole(whole, scan.volume->geometry));
  EXPECT_EQ(withinRegion(scan.volume, whole), scan.volume) << "no copy";
  EXPECT_FALSE(isWhole(regionOf(scan, {{0.5, 0, 0}, {0, 0, 0}}), scan.volume->geometry));
  auto erased = std::make_shared<Volume<std::uint8_t>>(scan.volume->geometry);
  erased->at(3, 4, 5) = 1;
  scan.erased = erased;
  EXPECT_FALSE(isWhole(regionOf(scan, {}), scan.volume->geometry));
}

TEST(Region, ErasedVoxelsAreOutside) {
  Scan scan = turnedScan();
  auto erased = std::make_shared<Volume<std::uint8_t>>(scan.volume->geometry);
  erased->at(3, 4, 5) = 200;
  scan.erased = erased;
  const Region region = regionOf(scan, {});
  EXPECT_FALSE(region.contains({3, 4, 5}));
  EXPECT_TRUE(region.contains({4, 4, 5}));
}

TEST(Region, WhatIsShownIsCutAndErased) {
  Scan scan = turnedScan();
  auto erased = std::make_shared<Volume<std::uint8_t>>(scan.volume->geometry);
  erased->at(6, 4, 5) = 1;
  scan.erased = erased;
  const Region region = regionOf(scan, {{1.0, 0.75, 0}, {0.5, 0, 2.5}});
  const auto part = withinRegion(scan.volume, region);
  const Geometry &g = scan.volume->geometry, &cut = part->geometry;
  EXPECT_EQ(cut.dims, glm::ivec3(17, 15, 8));
  for (int k = 0; k < cut.dims.z; ++k)
    for (int j = 0; j < cut.dims.y; ++j)
      for (int i = 0; i < cut.dims.x; ++i) {
        const glm::ivec3 v = glm::ivec3(glm::round(g.toIndex(cut.toWorld({i, j, k}))));
        const float expected = v == glm::ivec3(6, 4, 5) ? 0 : scan.volume->at(v.x, v.y, v.z);
        EXPECT_EQ(part->at(i, j, k), expected);
      }
}

TEST(Region, SaysWhichAxisHasNothingLeft) {
  const Scan scan = turnedScan();
  try {
    regionOf(scan, {{0, 6, 0}, {0, 6, 0}});
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("nothing is left of axis j"), std::string::npos) << e.what();
  }
  EXPECT_NO_THROW(regionOf(scan, {{0, 6, 0}, {0, 5.25, 0}})) << "one layer of voxels";
}

}  // namespace
}  // namespace sonoskin
