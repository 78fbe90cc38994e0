#include "app/document/erased_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/volumes.h"

namespace sonoskin {
namespace {

class ErasedPartsTest : public testing::Test {
 protected:
  ErasedPartsTest() {
    geometry.dims = {30, 24, 16};
    parts.reset(geometry);
  }
  // stroke: a ball about a voxel, erased or brought back.
  void stroke(const glm::dvec3& index, double radius, bool mark = true) {
    parts.paint({geometry.toWorld(index), geometry.toWorld(index), radius, mark});
    parts.endStroke();
  }
  std::size_t counted() const {
    return std::size_t(std::count(parts.mask().data.begin(), parts.mask().data.end(), std::uint8_t(1)));
  }
  Geometry geometry = test::turnedGeometry();
  ErasedParts parts;
};

TEST_F(ErasedPartsTest, NothingIsErasedAtFirst) {
  EXPECT_EQ(parts.voxels(), 0u);
  EXPECT_EQ(parts.snapshot(), nullptr);
  EXPECT_EQ(parts.key(), Key{});
  EXPECT_FALSE(parts.paint({geometry.toWorld({5, 5, 5}), geometry.toWorld({5, 5, 5}), 3, false}));
  EXPECT_TRUE(parts.mask().data.empty()) << "no memory without a stroke";
}

TEST_F(ErasedPartsTest, GoesBackAndForthThroughItsStrokes) {
  std::vector<LargeArray<std::uint8_t>> states;
  std::vector<Key> keys;
  const auto note = [&] {
    EXPECT_EQ(parts.voxels(), counted());
    states.push_back(parts.mask().data);
    keys.push_back(parts.key());
  };
  stroke({8, 8, 8}, 3);
  note();
  stroke({12, 10, 8}, 3);
  note();
  stroke({10, 9, 8}, 2, false);
  note();
  parts.clear();
  note();
  EXPECT_EQ(parts.voxels(), 0u);
  EXPECT_EQ(parts.key(), Key{});
  EXPECT_EQ(parts.strokes(), 4u);
  for (const std::size_t at : {2u, 4u, 1u, 3u}) {
    parts.goTo(at);
    EXPECT_EQ(parts.mask().data, states[at - 1]);
    EXPECT_EQ(parts.key(), keys[at - 1]);
    EXPECT_EQ(parts.voxels(), counted());
  }
  parts.goTo(0);
  EXPECT_EQ(parts.voxels(), 0u);
}

TEST_F(ErasedPartsTest, ANewStrokeForgetsThoseTakenBack) {
  stroke({8, 8, 8}, 3);
  stroke({12, 10, 8}, 3);
  parts.goTo(1);
  stroke({20, 10, 8}, 2);
  EXPECT_EQ(parts.strokes(), 2u);
  parts.goTo(9);
  EXPECT_EQ(parts.strokes(), 2u);
  EXPECT_EQ(parts.mask().at(20, 10, 8), 1);
  EXPECT_EQ(parts.mask().at(14, 10, 8), 0);
}

TEST_F(ErasedPartsTest, AStrokeGoesOnUntilItEnds) {
  for (int i = 5; i < 15; ++i) {
    const glm::dvec3 at = geometry.toWorld({i, 8, 8});
    parts.paint({at, at, 2, true});
  }
  EXPECT_EQ(parts.strokes(), 0u);
  parts.endStroke();
  parts.endStroke();
  EXPECT_EQ(parts.strokes(), 1u);
  stroke({8, 8, 8}, 1);  // changes nothing
  EXPECT_EQ(parts.strokes(), 1u);
}

TEST_F(ErasedPartsTest, SnapshotsStayAsTheyAre) {
  stroke({8, 8, 8}, 3);
  const auto first = parts.snapshot();
  EXPECT_EQ(parts.snapshot(), first);
  const auto data = first->data;
  stroke({12, 10, 8}, 3);
  EXPECT_EQ(first->data, data);
  EXPECT_EQ(parts.snapshot()->data, parts.mask().data);
}

TEST_F(ErasedPartsTest, BecomesWhatAFileHolds) {
  stroke({8, 8, 8}, 3);
  Volume<std::uint8_t> file(geometry);
  file.at(1, 2, 3) = 255;
  file.at(8, 8, 8) = 7;
  parts.become(file);
  EXPECT_EQ(parts.voxels(), 2u);
  EXPECT_EQ(parts.mask().at(8, 8, 8), 1);
  parts.goTo(1);
  EXPECT_GT(parts.voxels(), 2u);
}

}  // namespace
}  // namespace sonoskin
