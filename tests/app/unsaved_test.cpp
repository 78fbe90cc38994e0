// What counts as unsaved, and what becomes of work that is cancelled.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/document/session.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/session_support.h"
#include "tests/support/recording.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::OpenSession;
using test::TempFolder;
using test::tinyPhantom;
using test::tinySurface;
using test::wait;

void change(Session& session, const std::function<void(Parameters&)>& edit) {
  Parameters parameters = session.parameters();
  edit(parameters);
  session.edit(parameters);
  session.commitEdit();
  ASSERT_TRUE(wait(session));
}

TEST(Unsaved, ParametersRegionLandmarksAndParts) {
  OpenSession session;
  ASSERT_FALSE(session.hasUnsavedWork());
  const std::function<void(Parameters&)> edits[] = {[](Parameters& p) { p.classification.alpha = 1.7; },
                                                    [](Parameters& p) { p.region.cutLow[1] = 4; },
                                                    [](Parameters& p) {
                                                      p.landmarks.leftEye = {1, 2, 3};
                                                    },
                                                    [](Parameters& p) { p.skin.melanin = 0.06; },
                                                    [](Parameters& p) {
                                                      p.mesh.partsDrop = {{1, 2, 3}};
                                                    }};
  for (const auto& edit : edits) {
    change(session, edit);
    EXPECT_TRUE(session.hasUnsavedWork());
    session.undo();
    ASSERT_TRUE(wait(session));
    EXPECT_FALSE(session.hasUnsavedWork()) << "it is as it was opened";
  }
  change(session, edits[0]);
  const TempFolder folder;
  session.saveRecipe(folder / "a.recipe.json");
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasUnsavedWork());
  change(session, edits[1]);
  session.saveSession(folder / "a.sonoskin", "{}");
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasUnsavedWork());
  session.undo();
  EXPECT_TRUE(session.hasUnsavedWork());
}

// What the next scan is simulated with is not what was made of this one.
TEST(Unsaved, NotWhatTheNextScanIsOpenedWith) {
  OpenSession session;
  change(session, [](Parameters& p) { p.phantom.seed = 7; });
  EXPECT_FALSE(session.hasUnsavedWork());
}

// Looks at the session `looks` times, then cancels.
void cancelAfter(Session& session, int looks) {
  for (int n = 0; n < looks; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    session.poll();
  }
  session.cancel();
  ASSERT_TRUE(wait(session));
}

// What is open is whole, or says that it is not and goes on when told to.
void expectWholeInTheEnd(Session& session) {
  if (session.state() == DocumentState::stopped) session.resume();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), DocumentState::noSurface);
  ASSERT_TRUE(session.results().classified && session.results().points);
  EXPECT_FALSE(session.classifiedIsCoarse());
}

TEST(Cancel, WhileTheFirstDocumentOpensLeavesNothingHalfDone) {
  for (int looks = 0; looks < 30; looks += 5) {
    SCOPED_TRACE(looks);
    Session session(tinyPhantom());
    session.openPhantom();
    cancelAfter(session, looks);
    if (session.hasScan())
      expectWholeInTheEnd(session);
    else
      EXPECT_EQ(session.state(), DocumentState::empty);
  }
}

// Its coarse volume alone is no document that is up to date.
TEST(Cancel, WhileItIsClassifiedSaysSoAndGoesOn) {
  for (int looks = 0; looks < 30; looks += 3) {
    SCOPED_TRACE(looks);
    Session session(tinyPhantom());
    session.openPhantom();
    while (!session.hasScan()) session.poll();
    cancelAfter(session, looks);
    if (looks == 0) {
      EXPECT_EQ(session.state(), DocumentState::stopped);
    }
    expectWholeInTheEnd(session);
  }
}

TEST(Cancel, WhileAnotherOpensLeavesTheDocumentWhole) {
  for (int looks = 0; looks < 30; looks += 5) {
    SCOPED_TRACE(looks);
    OpenSession session;
    Parameters other = session.parameters();
    other.phantom.seed = 9;
    session.edit(other);
    session.openPhantom();
    cancelAfter(session, looks);
    expectWholeInTheEnd(session);
  }
}

// A result that nobody has taken in yet does not hide that more was asked for.
TEST(Cancel, HoldsBetweenTwoSteps) {
  OpenSession session;
  Parameters moved = session.parameters();
  moved.classification.beta = 2;
  session.edit(moved);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // it is done, and nobody has looked
  session.cancel();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), DocumentState::stopped);
  session.resume();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.state(), DocumentState::noSurface);
}

TEST(Cancel, OfASpacingLeavesTheOneThatIs) {
  std::string bytes = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 24 24 24\nencoding: raw\n\n";
  for (int v = 0; v < 24 * 24 * 24; ++v) bytes += char(v % 97);
  const TempFolder folder;
  Session session(tinyPhantom());
  session.openFile(folder.write("a.nrrd", bytes));
  ASSERT_TRUE(wait(session));
  Parameters spaced = session.parameters();
  spaced.scan.spacing = {0.5, 0.5, 0.5};
  session.edit(spaced);
  session.cancel();
  ASSERT_TRUE(wait(session));
  const bool isSpacedNow = session.scan().spacingKnown;  // it may have been done already
  EXPECT_EQ(session.parameters().scan.spacing[0], isSpacedNow ? 0.5 : 0);
}

}  // namespace
}  // namespace sonoskin
