#include "app/views/frame_share.h"

#include <gtest/gtest.h>

#include <array>

namespace sonoskin::ui {
namespace {

// Four views that turn together take no longer than one, whatever each of them would like.
TEST(FrameShare, FourViewsThatMoveAreAsFastAsOne) {
  SharedTime shared;
  std::array<FrameShare, 4> shares;
  constexpr double kBeside = 0.01;  // of a frame
  double frame = kBeside;
  std::array<SharingView, 4> views{};
  for (int n = 0; n < 30; ++n) {
    shareFrame(views, frame, shared, shares);
    frame = kBeside;
    for (std::size_t v = 0; v < 4; ++v) {
      views[v] = {shares[v].seconds, shares[v].seconds, v == 2, false};
      frame += shares[v].seconds;
    }
  }
  EXPECT_LT(frame, 1.0 / 15);
  EXPECT_GT(frame, 0.9 / MovingBudget::kFrames) << "and uses the time there is";
  for (const FrameShare& share : shares) EXPECT_TRUE(share.moves) << "one moves all";
}

// Where even the coarsest drafts take long, the view that is turned draws in each frame and one of the others with it.
TEST(FrameShare, OnASlowMachineThoseThatFollowTakeTurns) {
  SharedTime shared;
  std::array<FrameShare, 4> shares;
  std::array<SharingView, 4> views;
  for (std::size_t v = 0; v < 4; ++v) views[v] = {0.03, 0.03, v == 2, false};
  std::array<int, 4> drawn{};
  for (int n = 0; n < 6; ++n) {
    shareFrame(views, 0.07, shared, shares);
    for (std::size_t v = 0; v < 4; ++v) drawn[v] += shares[v].draws;
  }
  EXPECT_EQ(drawn, (std::array{2, 2, 6, 2}));
  for (SharingView& view : views) view.moving = false;
  shareFrame(views, 0.07, shared, shares);
  for (const FrameShare& share : shares) EXPECT_TRUE(share.draws) << "what rests is drawn";
}

TEST(FrameShare, OneAfterTheOtherBecomesBetter) {
  SharedTime shared;
  std::array<FrameShare, 3> shares;
  const std::array<SharingView, 3> views{SharingView{}, SharingView{.unfinished = true},
                                         SharingView{.unfinished = true}};
  shareFrame(views, 0.02, shared, shares);
  EXPECT_FALSE(shares[0].refines);
  EXPECT_TRUE(shares[1].refines);
  EXPECT_FALSE(shares[2].refines);
  EXPECT_FALSE(shares[1].moves);
}

TEST(FrameShare, AViewAloneHasAllOfIt) {
  SharedTime shared;
  std::array<FrameShare, 1> share;
  shareFrame(std::array{SharingView{.moving = true}}, 0.02, shared, share);
  EXPECT_TRUE(share[0].refines);
  EXPECT_FALSE(share[0].moves) << "it knows that itself";
  EXPECT_EQ(share[0].seconds, shared.budget.seconds());
}

}  // namespace
}  // namespace sonoskin::ui
