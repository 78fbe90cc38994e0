// Sessions: what was open is saved whole, and comes back.
#include "app/document/session_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/document/session.h"
#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/stage_keys.h"
#include "tests/app/session_support.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::ballOnTheSurface;
using test::TempFolder;
using test::tinySurface;
using test::wait;

SessionFile someSession() {
  SessionFile session;
  session.volume = "/data/scan.nrrd";
  session.recipe = writeRecipe({});
  session.hasSurface = true;
  session.follows = false;
  session.views = R"({"cursor":[1.5,2.0,3.0]})";
  return session;
}

TEST(SessionFile, ReadsBackWhatItWrote) {
  const SessionFile session = someSession(), read = readSessionFile(writeSessionFile(session));
  EXPECT_EQ(read.volume, session.volume);
  EXPECT_EQ(read.views, session.views);
  EXPECT_TRUE(read.hasSurface);
  EXPECT_FALSE(read.follows);
  Parameters parameters;
  readRecipe(read.recipe, parameters);
  EXPECT_EQ(parametersKey(parameters), parametersKey({}));
}

TEST(SessionFile, WhatIsNoSessionIsRefused) {
  const std::string whole = writeSessionFile(someSession());
  for (std::size_t length = 0; length + 2 < whole.size(); length += 97)
    EXPECT_THROW(readSessionFile(whole.substr(0, length)), Error) << length;
  EXPECT_THROW(readSessionFile(writeRecipe({})), Error);
  EXPECT_THROW(readSessionFile(R"({"sonoskin_session": 1})"), Error);
  EXPECT_THROW(readSessionFile(R"({"sonoskin_session": 2, "recipe": {}})"), Error);
  EXPECT_THROW(readSessionFile(R"({"sonoskin_session": 1, "recipe": [1]})"), Error);
  // What takes a text apart calls itself once a level.
  const std::string deep(3'000'000, '[');
  EXPECT_THROW(readSessionFile(R"({"sonoskin_session": 1, "recipe": {}, "views": {"a": )" + deep), Error);
  EXPECT_THROW(readSessionFile(R"({"sonoskin_session": 1, "recipe": {}, "views": {"a": )" + deep +
                               std::string(deep.size(), ']') + "}}"),
               Error);
}

TEST(SessionFile, IsARecipeToo) {
  Parameters parameters;
  parameters.classification.alpha = 2.5;
  SessionFile session = someSession();
  session.recipe = writeRecipe(parameters);
  Parameters read;
  readRecipe(recipeIn(writeSessionFile(session)), read);
  EXPECT_EQ(read.classification.alpha, 2.5);
  EXPECT_EQ(recipeIn(session.recipe), session.recipe);
}

// A document on a file, with all that a person may have made of it.
struct WorkedOn {
  const TempFolder folder;
  const fs::path volume = folder / "scan.nrrd", file = folder / "face.sonoskin";
  Session session{tinySurface()};

  WorkedOn() {
    writeScan(volume, makePhantomScan(tinySurface().phantom));
    session.openFile(volume);
    EXPECT_TRUE(wait(session));
    session.erase(ballOnTheSurface(session));
    Parameters parameters = session.parameters();
    parameters.classification.beta = 1.3;
    parameters.region.cutLow[0] = 3;
    parameters.landmarks.noseTip = {7, 8, 9};
    parameters.skin.melanin = 0.07;
    session.edit(parameters);
    session.commitEdit();
    EXPECT_TRUE(wait(session));
    session.reconstruct();
    EXPECT_TRUE(wait(session));
    EXPECT_TRUE(session.results().mesh);
  }
  void save() {
    session.saveSession(file, R"({"layer":"thinned"})");
    EXPECT_TRUE(wait(session));
    EXPECT_FALSE(session.hasUnsavedWork());
  }
};

TEST(Sessions, WhatIsOpenedAgainIsWhatWasSaved) {
  WorkedOn before;
  EXPECT_TRUE(before.session.hasUnsavedWork());
  before.save();
  Session session{Parameters()};
  session.openSession(before.file);
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.takeMessages().empty());
  EXPECT_EQ(session.scan().key, before.session.scan().key);
  EXPECT_EQ(contentKey(session.parameters()), contentKey(before.session.parameters()));
  EXPECT_EQ(session.erased().mask().data, before.session.erased().mask().data);
  ASSERT_TRUE(session.results().mesh);
  EXPECT_EQ(session.results().mesh->positions, before.session.results().mesh->positions);
  EXPECT_TRUE(session.meshIsCurrent() && session.meshIsFinal());
  EXPECT_EQ(session.state(), DocumentState::current);
  EXPECT_FALSE(session.canUndo());
  EXPECT_FALSE(session.hasUnsavedWork()) << "it is as it was saved";
  EXPECT_EQ(session.reconstructions(), 0u) << "nobody asked for a surface here";
  const auto reopened = session.takeReopened();
  ASSERT_TRUE(reopened);
  EXPECT_EQ(reopened->file.views, R"({"layer":"thinned"})");
  EXPECT_FALSE(session.takeReopened());
}

TEST(Sessions, OfASimulatedScanSimulateIt) {
  test::OpenSession before(tinySurface());
  const TempFolder folder;
  before.saveSession(folder / "a.sonoskin", "{}");
  ASSERT_TRUE(wait(before));
  Session session{Parameters()};
  session.openSession(folder / "a.sonoskin");
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.scan().key, before.scan().key);
  EXPECT_EQ(session.name(), "Phantom");
  EXPECT_FALSE(session.results().mesh);
}

TEST(Sessions, AskForAVolumeThatHasMovedOrIsAnother) {
  WorkedOn before;
  before.save();
  fs::create_directory(before.folder / "elsewhere");
  const fs::path moved = before.folder / "elsewhere/scan.nrrd";
  fs::rename(before.volume, moved);
  PhantomOptions other = tinySurface().phantom;
  other.seed = 5;
  Session session{Parameters()};
  session.openSession(before.file);
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasScan());
  auto lost = session.takeLostVolume();
  ASSERT_TRUE(lost);
  EXPECT_NE(lost->why.find("not there"), std::string::npos) << lost->why;
  writeScan(before.volume, makePhantomScan(other));
  session.openSession(*lost, before.volume);
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasScan());
  lost = session.takeLostVolume();
  ASSERT_TRUE(lost);
  EXPECT_NE(lost->why.find("another volume"), std::string::npos) << lost->why;
  session.openSession(*lost, moved);
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.results().mesh);
  EXPECT_EQ(session.erased().voxels(), before.session.erased().voxels());
}

// Both were carried to another machine.
TEST(Sessions, FindTheirVolumeBesideThem) {
  WorkedOn before;
  before.save();
  const TempFolder other;
  fs::copy_file(before.file, other / "face.sonoskin");
  fs::rename(before.volume, other / "scan.nrrd");
  Session session{Parameters()};
  session.openSession(other / "face.sonoskin");
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.hasScan());
  EXPECT_EQ(session.source(), other / "scan.nrrd");
}

TEST(Sessions, WhatIsRestoredIsNotSaved) {
  WorkedOn before;
  before.save();
  Session session{Parameters()};
  session.openSession(before.file, true);
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.hasScan());
  EXPECT_TRUE(session.hasUnsavedWork());
}

TEST(Sessions, DamagedOnesLeaveTheDocument) {
  test::OpenSession session(tinySurface());
  const Key key = session.scan().key;
  const TempFolder folder;
  session.openSession(folder.write("bad.sonoskin", R"({"sonoskin_session": 1, "recipe": {"mesh": 3}})"));
  ASSERT_TRUE(wait(session));
  const auto messages = session.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].kind, Message::Kind::failure);
  EXPECT_EQ(session.scan().key, key);
}

}  // namespace
}  // namespace sonoskin
