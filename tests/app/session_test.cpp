// What a session makes of its parameters: results that follow them, strokes, undo.
#include "app/document/session.h"

#include <gtest/gtest.h>

#include "tests/app/session_support.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::ballOnTheSurface;
using test::OpenSession;
using test::tinyPhantom;
using test::tinySurface;
using test::wait;

TEST(Session, UndoBringsParametersAndResultsBack) {
  OpenSession session;
  const auto first = session.results().classified;

  Parameters changed = session.parameters();
  for (const double beta : {1.5, 2.0, 3.0}) {  // a slider on its way
    changed.classification.beta = beta;
    session.edit(changed);
  }
  EXPECT_FALSE(session.canUndo());
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  ASSERT_NE(session.results().classified->data, first->data);

  ASSERT_TRUE(session.canUndo());
  session.undo();
  EXPECT_DOUBLE_EQ(session.parameters().classification.beta, 1);
  EXPECT_FALSE(session.canUndo());
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.results().classified->data, first->data);

  session.redo();
  EXPECT_DOUBLE_EQ(session.parameters().classification.beta, 3);
  EXPECT_FALSE(session.canRedo());
}

TEST(Session, MeshIsCurrentUntilAParameterChanges) {
  OpenSession session(tinySurface());
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.results().mesh);
  EXPECT_TRUE(session.meshIsCurrent());
  EXPECT_GT(session.meshArea(), 100);
  EXPECT_EQ(session.reconstructions(), 1u);

  const Parameters before = session.parameters();
  Parameters other = before;
  other.classification.alpha = 2;
  session.edit(other);
  EXPECT_FALSE(session.meshIsCurrent());
  session.edit(before);
  EXPECT_TRUE(session.meshIsCurrent());
}

TEST(Session, TheSurfaceFollowsTheParametersOnceThereIsOne) {
  OpenSession session(tinySurface());
  Parameters p = session.parameters();
  p.surface.minClusterArea = 15;
  session.edit(p);
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.results().mesh);  // nobody asked for one yet
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.meshIsFinal());
  const auto first = session.results().mesh;

  p.reconstruction.smoothness = 2e-4;
  session.edit(p);
  ASSERT_TRUE(wait(session));
  EXPECT_NE(session.results().mesh, first);
  EXPECT_TRUE(session.meshIsCurrent() && session.meshIsFinal());  // the classification is the final one still

  p.classification.alpha = 2;
  session.edit(p);
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.meshIsCurrent());
  EXPECT_FALSE(session.meshIsFinal());
  EXPECT_EQ(session.reconstructions(), 1u);  // of those asked for

  session.followParameters(false);
  const auto live = session.results().mesh;
  p.reconstruction.smoothness = 1e-4;
  session.edit(p);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.results().mesh, live);
  EXPECT_FALSE(session.meshIsCurrent());
  session.followParameters(true);
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.meshIsCurrent());
}

TEST(Session, AStrokeTakesPointsAwayAndUndoBringsThemBack) {
  OpenSession session;
  const auto classified = session.results().classified;
  const auto whole = session.results().points;
  ASSERT_GT(whole->size(), 100u);
  const Brush ball = ballOnTheSurface(session);
  session.erase(ball);
  EXPECT_FALSE(session.canUndo()) << "the stroke goes on";
  session.commitEdit();
  ASSERT_TRUE(session.canUndo());
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.results().classified, classified) << "not computed again";
  EXPECT_LT(session.results().points->size(), whole->size());
  for (const glm::vec3& p : session.results().points->positions)
    EXPECT_GT(glm::distance(glm::dvec3(p), ball.to), 8);  // they were moved onto the skin

  // Strokes and parameters are undone in the order in which they were made.
  Parameters cut = session.parameters();
  cut.region.cutLow[0] = 20;
  session.edit(cut);
  session.commitEdit();
  session.undo();
  EXPECT_EQ(session.parameters().region.cutLow[0], 0);
  EXPECT_GT(session.erased().voxels(), 0u);
  session.undo();
  EXPECT_EQ(session.erased().voxels(), 0u);
  EXPECT_FALSE(session.canUndo());
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.results().points->positions, whole->positions);
  session.redo();
  session.redo();
  EXPECT_GT(session.erased().voxels(), 0u);
  EXPECT_EQ(session.parameters().region.cutLow[0], 20);
}

TEST(Session, AMeshIsOlderThanAStroke) {
  OpenSession session(tinySurface());
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.meshIsCurrent());
  session.erase(ballOnTheSurface(session));
  session.commitEdit();
  EXPECT_FALSE(session.meshIsCurrent());
  session.undo();
  EXPECT_TRUE(session.meshIsCurrent());
}

// What only pictures depend on makes nothing anew, but can be undone and is saved.
TEST(Session, SkinLightAndLandmarksChangePicturesAlone) {
  OpenSession session(tinySurface());
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  const auto mesh = session.results().mesh;
  ASSERT_TRUE(mesh && session.meshIsFinal());
  const std::uint64_t revision = session.revision();

  Parameters p = session.parameters();
  p.skin.wetness = 0.7;
  session.edit(p);
  p.light.azimuth = 120;
  p.landmarks.noseTip = {1, 2, 3};
  session.edit(p);
  session.commitEdit();
  EXPECT_FALSE(session.activity().busy) << "nothing has to be computed";
  EXPECT_TRUE(session.meshIsCurrent() && session.meshIsFinal());
  EXPECT_EQ(session.revision(), revision);

  session.undo();
  EXPECT_EQ(session.parameters().skin.wetness, SkinOptions{}.wetness);
  EXPECT_EQ(session.parameters().light.azimuth, LightOptions{}.azimuth);
  EXPECT_FALSE(session.activity().busy);
  session.redo();
  EXPECT_EQ(session.parameters().skin.wetness, 0.7);
  EXPECT_EQ(session.results().mesh, mesh);

  const test::TempFolder folder;
  const auto file = folder / "look.recipe.json";
  session.saveRecipe(file);
  ASSERT_TRUE(wait(session));
  session.undo();
  session.loadRecipe(file);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.parameters().light.azimuth, 120);
  EXPECT_FALSE(session.activity().busy);
  EXPECT_EQ(session.results().mesh, mesh);
}

TEST(Session, ItsStateFollowsWhatIsDone) {
  using enum DocumentState;
  Session session(tinySurface());
  EXPECT_EQ(session.state(), empty);
  session.openPhantom();
  EXPECT_EQ(session.state(), opening);
  session.cancel();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), empty) << "a cancelled opening leaves nothing";
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), noSurface);
  session.reconstruct();
  EXPECT_EQ(session.state(), working);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), current);

  Parameters p = session.parameters();
  p.classification.gamma *= 2;
  session.edit(p);
  EXPECT_EQ(session.state(), working);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), live);
  session.followParameters(false);
  p.classification.gamma *= 1.5;
  session.edit(p);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), older);

  p.region.cutLow = {0, 70, 0};  // nothing is left
  session.edit(p);
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), failed);
  p.region.cutLow = {0, 0, 0};
  session.edit(p);
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), current);
}

// What the person stopped can be taken up again, and does not pass for done.
TEST(Session, GoesOnWhereItWasStopped) {
  Session session(tinyPhantom());
  session.openPhantom();
  const Timer timer;
  while (!session.hasScan() && timer.seconds() < 60) session.poll();
  session.cancel();  // the classification of what was opened
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.state(), DocumentState::stopped);
  EXPECT_FALSE(session.results().points);
  session.resume();
  EXPECT_EQ(session.state(), DocumentState::working);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), DocumentState::noSurface);
  EXPECT_FALSE(session.classifiedIsCoarse());
  EXPECT_TRUE(session.results().points);
}

// Parameters that a surface depends on only by way of another group.
TEST(Session, AMeshOfTheGlobalFunctionIsOlderThanItsParameters) {
  Parameters small = tinySurface();
  small.mesh.resolution = 40;
  small.reconstruction.method = ReconstructionMethod::global;
  OpenSession session(small);
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.meshIsCurrent());
  Parameters p = session.parameters();
  p.global.accuracy *= 2;
  session.edit(p);
  EXPECT_FALSE(session.meshIsCurrent());
}

}  // namespace
}  // namespace sonoskin
