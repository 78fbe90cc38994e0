#include "core/volume/scan_size.h"

#include <gtest/gtest.h>

#include "core/base/available_memory.h"
#include "core/base/error.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

Scan scanOf(const glm::ivec3& dims, const glm::dvec3& spacing) {
  Volume<float> volume(test::grid(dims, spacing));
  for (std::size_t v = 0; v < volume.data.size(); ++v) volume.data[v] = float(v % 97) / 97;
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(std::move(volume));
  scan.key = scanKey(*scan.volume, scan.beam);
  return scan;
}

TEST(ScanSize, NothingIsLeftOutUnlessAskedFor) {
  Scan scan = scanOf({20, 16, 12}, {0.5, 0.5, 0.5});
  const Scan before = scan;
  reduceScan(scan, {});
  EXPECT_EQ(scan.volume, before.volume);
  EXPECT_EQ(scan.key, before.key);
}

TEST(ScanSize, HalfTheResolutionStaysInItsPlace) {
  Scan scan = scanOf({20, 16, 12}, {0.5, 0.5, 0.5});
  const Scan before = scan;
  ScanOptions options;
  options.half = true;
  reduceScan(scan, options);
  const Geometry &g = scan.volume->geometry, &whole = before.volume->geometry;
  EXPECT_EQ(g.dims, glm::ivec3(10, 8, 6));
  EXPECT_NEAR(glm::distance(g.toWorld({0, 0, 0}), whole.toWorld({0.5, 0.5, 0.5})), 0, 1e-9);
  EXPECT_FALSE(scan.key == before.key);
}

TEST(ScanSize, APartHasTheVoxelsThatItHad) {
  Scan scan = scanOf({20, 16, 12}, {0.5, 0.5, 0.5});
  const Scan before = scan;
  ScanOptions options;
  options.cutLow = {1, 0, 0.7};
  options.cutHigh = {2, 0.5, 0};
  reduceScan(scan, options);
  const Geometry& g = scan.volume->geometry;
  EXPECT_EQ(g.dims, glm::ivec3(14, 15, 10));
  EXPECT_EQ(scan.volume->at(3, 4, 5), before.volume->at(5, 4, 7));
  EXPECT_NEAR(glm::distance(g.toWorld({3, 4, 5}), before.volume->geometry.toWorld({5, 4, 7})), 0, 1e-9);
  options.cutLow = {9, 0, 0};
  EXPECT_THROW(reduceScan(scan, options), Error);
}

TEST(ScanSize, TooLittleMemoryNamesWhatHelps) {
  const Geometry g = test::grid({1000, 100, 100});
  EXPECT_NO_THROW(requireMemory(g, 16, 160'000'000));
  try {
    requireMemory(g, 16, 159'000'000);
    FAIL();
  } catch (const Error& error) {
    const std::string text = error.what();
    for (const char* word : {"1000 x 100 x 100", "0.2 GB", "scan.half", "scan.cutLow", "scan.cutHigh"})
      EXPECT_NE(text.find(word), std::string::npos) << word;
  }
}

TEST(ScanSize, SomeMemoryIsThere) { EXPECT_GT(availableMemory(), std::size_t(10) << 20); }

}  // namespace
}  // namespace sonoskin
