#include "app/document/frame.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

TEST(FrameOfResults, SlicesAloneDoNotMakeTheVolumeBeforeCurrent) {
  Frame frame;
  const auto volume = std::make_shared<const Volume<float>>(Geometry{.dims = {2, 2, 2}}, 0.0f);
  Results first;
  first.classified = volume;
  first.keys.classified = Hasher("before").key();
  takeIn(frame, first, {}, {});

  Results slices;
  slices.slices[2] = volume;
  slices.keys.classified = Hasher("after").key();
  takeIn(frame, slices, {}, {});
  EXPECT_EQ(frame.results.classified, volume);
  EXPECT_TRUE(frame.results.slices[2]);
  EXPECT_TRUE(frame.results.keys.classified == first.keys.classified)
      << "what is there is older than the slices";
}

}  // namespace
}  // namespace sonoskin
