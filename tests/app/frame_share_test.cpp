#include "app/views/frame_share.h"

#include <gtest/gtest.h>

#include <array>

namespace sonoskin::ui {
namespace {

// Four views that turn together take no longer than one, whatever each of them would like.
TEST(FrameShare, FourViewsThatMoveAreAsFastAsOne) {
  MovingBudget budget;
  std::array<FrameShare, 4> shares;
  constexpr double kBeside = 0.01;  // of a frame
  double frame = kBeside;
  std::array<SharingView, 4> views{};
  for (int n = 0; n < 30; ++n) {
    shareFrame(views, frame, budget, shares);
    frame = kBeside;
    for (std::size_t v = 0; v < 4; ++v) {
      views[v] = {shares[v].seconds, v == 2, false};
      frame += shares[v].seconds;
    }
  }
  EXPECT_LT(frame, 1.0 / 15);
  EXPECT_GT(frame, 0.9 / MovingBudget::kFrames) << "and uses the time there is";
  for (const FrameShare& share : shares) EXPECT_TRUE(share.moves) << "one moves all";
}

TEST(FrameShare, OneAfterTheOtherBecomesBetter) {
  MovingBudget budget;
  std::array<FrameShare, 3> shares;
  const std::array<SharingView, 3> views{SharingView{0, false, false}, SharingView{0, false, true},
                                         SharingView{0, false, true}};
  shareFrame(views, 0.02, budget, shares);
  EXPECT_FALSE(shares[0].refines);
  EXPECT_TRUE(shares[1].refines);
  EXPECT_FALSE(shares[2].refines);
  EXPECT_FALSE(shares[1].moves);
}

TEST(FrameShare, AViewAloneHasAllOfIt) {
  MovingBudget budget;
  std::array<FrameShare, 1> share;
  shareFrame(std::array{SharingView{0, true, false}}, 0.02, budget, share);
  EXPECT_TRUE(share[0].refines);
  EXPECT_FALSE(share[0].moves) << "it knows that itself";
  EXPECT_EQ(share[0].seconds, budget.seconds());
}

}  // namespace
}  // namespace sonoskin::ui
