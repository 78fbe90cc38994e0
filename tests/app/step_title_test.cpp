#include "app/workspace/step_title.h"

#include <gtest/gtest.h>

#include "tests/app/session_support.h"

namespace sonoskin {
namespace {

using test::OpenSession;
using test::wait;

std::string titleOf(const std::function<void(Parameters&)>& edit) {
  Version before, after;
  edit(after.parameters);
  return stepTitle(before, after);
}

TEST(StepTitle, SaysWhatChanged) {
  EXPECT_EQ(titleOf([](Parameters& p) { p.classification.alpha = 1.4; }), "α 1 → 1.4");
  EXPECT_EQ(titleOf([](Parameters& p) { p.region.cutLow = {1, 2, 3}; }), "Crop box");
  EXPECT_EQ(titleOf([](Parameters& p) { p.landmarks.leftEye = {1, 2, 3}; }), "Landmark");
  EXPECT_EQ(titleOf([](Parameters& p) { p.mesh.partsDrop = {{1, 2, 3}}; }), "Part taken away");
  EXPECT_EQ(titleOf([](Parameters& p) { p.mesh.partsCut = {{1, 2, 3}}; }), "Part split");
  EXPECT_EQ(titleOf([](Parameters& p) { p.scan.time = 4; }), "Time step 1 → 4");
  EXPECT_EQ(titleOf([](Parameters& p) { p.face.find = !p.face.find; }).substr(0, 4), "Find");
  const std::string several = titleOf([](Parameters& p) {
    p.classification.alpha = 1.4;
    p.classification.beta = 3;
    p.light.fill = 0.1;
  });
  EXPECT_NE(several.find("and 2 more"), std::string::npos) << several;
}

TEST(StepTitle, SaysHowMuchWasErased) {
  Version before, after;
  after.erased = 1240;
  EXPECT_EQ(stepTitle(before, after), "Erased 1,240 voxels");
  before.erased = 2000;
  EXPECT_EQ(stepTitle(before, after), "Brought 760 voxels back");
  after.erased = 0;
  EXPECT_EQ(stepTitle(before, after), "Nothing is erased any more");
}

// Any step can be gone to, and the way back is kept.
TEST(History, GoesToAnyStep) {
  OpenSession session;
  const auto edit = [&](double alpha) {
    Parameters parameters = session.parameters();
    parameters.classification.alpha = alpha;
    session.edit(parameters);
    session.commitEdit();
  };
  edit(2);
  session.erase(test::ballOnTheSurface(session));
  session.commitEdit();
  edit(3);
  ASSERT_EQ(session.history().size(), 4u);
  EXPECT_EQ(session.history().position(), 3u);
  const std::size_t erased = session.erased().voxels();
  session.goToStep(1);
  EXPECT_EQ(session.parameters().classification.alpha, 2);
  EXPECT_EQ(session.erased().voxels(), 0u);
  session.goToStep(0);
  EXPECT_EQ(session.parameters().classification.alpha, 1);
  session.goToStep(3);
  EXPECT_EQ(session.parameters().classification.alpha, 3);
  EXPECT_EQ(session.erased().voxels(), erased);
  EXPECT_FALSE(session.canRedo());
  ASSERT_TRUE(wait(session));
}

}  // namespace
}  // namespace sonoskin
