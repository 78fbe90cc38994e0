#include "app/workspace/stages.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "app/workspace/workspace.h"
#include "tests/app/session_support.h"

namespace sonoskin {
namespace {

using enum StageState;

Stage stage(const Workspace& workspace, Step step) { return stagesOf(workspace)[std::size_t(step)]; }
StageState state(const Workspace& workspace, Step step) { return stage(workspace, step).state; }

struct Opened : Workspace {
  Opened() : Workspace(test::tinySurface()) {
    session.openPhantom();
    if (!test::wait(session)) throw std::runtime_error("The phantom was not opened");
  }
};

TEST(Stages, NothingIsThereAtFirst) {
  const Workspace workspace{Parameters()};
  for (const Stage& s : stagesOf(workspace)) {
    EXPECT_EQ(s.state, nothing) << stepName(s.step);
    EXPECT_TRUE(s.number.empty());
  }
}

TEST(Stages, EachTellsWhatItHas) {
  Opened w;
  EXPECT_EQ(state(w, Step::volume), ready);
  EXPECT_EQ(stage(w, Step::volume).number, "78 × 43 × 31");
  EXPECT_EQ(stage(w, Step::region).number, "whole volume");
  EXPECT_EQ(state(w, Step::classify), ready);
  EXPECT_GT(stage(w, Step::classify).seconds, 0);
  EXPECT_EQ(state(w, Step::surface), nothing) << "no surface was asked for";
  EXPECT_NE(stage(w, Step::surface).number.find("points"), std::string::npos);
  EXPECT_EQ(state(w, Step::output), nothing);

  w.session.reconstruct();
  EXPECT_NE(state(w, Step::surface), ready);
  ASSERT_TRUE(test::wait(w.session));
  EXPECT_EQ(state(w, Step::surface), ready);
  EXPECT_NE(stage(w, Step::surface).number.find("triangles"), std::string::npos);
  EXPECT_EQ(stage(w, Step::output).number, "not saved yet");

  Parameters cut = w.session.parameters();
  cut.region.cutLow[0] =
      0.5 * w.session.scan().volume->geometry.spacing.x * (w.session.scan().volume->geometry.dims.x - 1);
  w.session.edit(cut);
  EXPECT_EQ(stage(w, Step::region).number, "50.0 % left");
}

// A surface that is older than the parameters is never called ready, nor what follows from it.
TEST(Stages, WhatIsOlderThanTheParametersIsStale) {
  Opened w;
  w.session.reconstruct();
  ASSERT_TRUE(test::wait(w.session));
  w.session.followParameters(false);
  w.view.content = SpaceContent::mesh;
  Parameters p = w.session.parameters();
  p.classification.alpha = 2;
  w.session.edit(p);
  EXPECT_NE(state(w, Step::classify), ready);
  EXPECT_NE(state(w, Step::surface), ready);
  ASSERT_TRUE(test::wait(w.session));
  EXPECT_EQ(state(w, Step::classify), ready);
  EXPECT_EQ(state(w, Step::surface), stale);
  EXPECT_EQ(state(w, Step::skin), stale);
}

// A volume that was stopped on its way from coarse to full says so until somebody goes on.
TEST(Stages, WhatWasCancelledIsStoppedUntilItIsContinued) {
  Workspace w(test::tinySurface());
  w.session.openPhantom();
  while (!w.session.hasScan()) w.session.poll();
  w.session.cancel();
  ASSERT_TRUE(test::wait(w.session));
  EXPECT_EQ(w.session.state(), DocumentState::stopped);
  const Stage classify = stage(w, Step::classify);
  EXPECT_TRUE(classify.state == stopped || !w.session.classifiedIsCoarse()) << int(classify.state);
  EXPECT_EQ(state(w, Step::surface), stopped);
  w.session.resume();
  ASSERT_TRUE(test::wait(w.session));
  EXPECT_EQ(state(w, Step::classify), ready);
  EXPECT_TRUE(w.session.results().points);
  EXPECT_EQ(w.session.state(), DocumentState::noSurface);
}

// The worker may have ended when the person cancels, though the window has not looked yet: what follows is not begun.
TEST(Stages, ACancelBetweenTwoPiecesOfWorkCounts) {
  Opened w;
  const auto points = w.session.results().points;
  Parameters p = w.session.parameters();
  p.classification.alpha = 2;
  w.session.edit(p);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  w.session.cancel();
  ASSERT_TRUE(test::wait(w.session));
  EXPECT_EQ(w.session.state(), DocumentState::stopped);
  EXPECT_EQ(w.session.results().points, points);
  w.session.resume();
  ASSERT_TRUE(test::wait(w.session));
  EXPECT_NE(w.session.results().points, points);
}

TEST(Stages, WordsAndTitlesAreDifferent) {
  std::set<std::string> words, titles, names;
  for (int s = 0; s <= int(failed); ++s) words.insert(stageWord(StageState(s)));
  EXPECT_EQ(words.size(), 7u);
  for (const Step step : kSteps) {
    titles.insert(stepTitle(step));
    names.insert(stepName(step));
    EXPECT_GT(std::string(stepHelp(step)).size(), 10u);
  }
  EXPECT_EQ(titles.size(), kSteps.size());
  EXPECT_EQ(names.size(), kSteps.size());
}

TEST(TimeLeft, FollowsFromWhatIsDone) {
  TimeLeft left;
  Activity activity{true, true, 0, "classification"};
  EXPECT_FALSE(left.of(activity, 10));
  activity.fraction = 0.01;
  EXPECT_FALSE(left.of(activity, 12)) << "a guess";
  activity.fraction = 0.25;
  ASSERT_TRUE(left.of(activity, 20));
  EXPECT_NEAR(*left.of(activity, 20), 30, 1e-9);
  activity.fraction = 0.1;  // another job
  EXPECT_FALSE(left.of(activity, 21));
  activity.fraction = 0.2;
  EXPECT_NEAR(*left.of(activity, 22), 4, 1e-9);
  EXPECT_FALSE(left.of({}, 23));
  EXPECT_EQ(timeLeftText({}), "");
  EXPECT_EQ(timeLeftText(29.2), "30 s left");
  EXPECT_EQ(timeLeftText(100), "2 min left");
}

}  // namespace
}  // namespace sonoskin
