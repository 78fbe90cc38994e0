// What a session saves, and what it knows of what is not saved.
#include "app/document/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/io/mesh_reader.h"
#include "core/mesh/facts/mesh_facts.h"
#include "tests/app/session_support.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::ballOnTheSurface;
using test::OpenSession;
using test::TempFolder;
using test::tinyPhantom;
using test::wait;

TEST(Session, KnowsWhatWouldBeLost) {
  OpenSession session;
  EXPECT_FALSE(session.hasUnsavedWork());
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.hasUnsavedWork());
  const TempFolder folder;
  session.saveMesh(folder / "face.ply");
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasUnsavedWork());
  session.followParameters(false);  // the surface stays the one that is saved
  session.erase(ballOnTheSurface(session));
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  ASSERT_GT(session.erased().voxels(), 0u);
  EXPECT_TRUE(session.hasUnsavedWork());
  session.saveErased(folder / "face.erased.nrrd");
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasUnsavedWork());
}

// A file of somebody else's that has the recipe's name is left alone, and said so.
TEST(Session, LeavesForeignFilesBesideAnExportAlone) {
  OpenSession session;
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  const TempFolder folder;
  std::ofstream(folder / "face.recipe.json") << "{\"cake\": \"flour\"}";
  session.takeMessages();
  session.saveMesh(folder / "face.ply");
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(fs::exists(folder / "face.ply"));
  std::ifstream kept(folder / "face.recipe.json");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), "{\"cake\": \"flour\"}");
  const auto messages = session.takeMessages();
  EXPECT_TRUE(std::ranges::any_of(messages, [](const Message& m) {
    return m.kind == Message::Kind::failure && m.text.find("something else") != std::string::npos;
  }));
}

TEST(Session, ErasedPartsAreSavedAndOpenedAgain) {
  const TempFolder folder;
  const fs::path file = folder / "face.erased.nrrd";
  Session session(tinyPhantom());
  EXPECT_THROW(session.saveErased(file), Error);
  EXPECT_THROW(session.loadErased(file), Error);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.erase(ballOnTheSurface(session));
  session.commitEdit();
  const auto mask = session.erased().mask().data;
  session.saveErased(file);
  ASSERT_TRUE(wait(session));
  session.clearErased();
  EXPECT_EQ(session.erased().voxels(), 0u);
  session.loadErased(file);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.erased().mask().data, mask);
  session.undo();
  EXPECT_EQ(session.erased().voxels(), 0u);

  session.loadErased("/nowhere/at/all.nrrd");
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.takeMessages().back().kind, Message::Kind::failure);
}

TEST(Session, SavesASolidForPrinting) {
  const TempFolder folder;
  Session session(test::tinySurface());
  EXPECT_THROW(session.savePrint(folder / "nothing.stl"), Error);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  session.takeMessages();
  const fs::path file = folder / "face.stl";
  session.savePrint(file);
  EXPECT_TRUE(session.saving());
  ASSERT_TRUE(wait(session));
  const std::vector<Message> messages = session.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].kind, Message::Kind::note) << messages[0].text;
  EXPECT_TRUE(measureMesh(readMesh(file)).printable());
}

TEST(Session, SavesTheRecipeBesideTheMeshAndReadsItAgain) {
  Session session(tinyPhantom());
  const TempFolder folder;
  EXPECT_THROW(session.saveMesh(folder / "nothing.ply"), Error);
  const fs::path file = folder / "face.recipe.json";
  Parameters changed = tinyPhantom();
  changed.classification.gamma = 0.5;
  session.edit(changed);
  session.commitEdit();
  session.saveRecipe(file);
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.takeMessages().size(), 1u);

  Session other{Parameters()};
  other.loadRecipe(file);
  EXPECT_DOUBLE_EQ(other.parameters().classification.gamma, Parameters().classification.gamma)
      << "the window does not wait for a disk";
  ASSERT_TRUE(wait(other));
  EXPECT_DOUBLE_EQ(other.parameters().classification.gamma, 0.5);
  EXPECT_TRUE(other.canUndo());
  fs::remove(file);
  other.loadRecipe(file);
  ASSERT_TRUE(wait(other));
  const auto messages = other.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].kind, Message::Kind::failure);
  EXPECT_DOUBLE_EQ(other.parameters().classification.gamma, 0.5);
}

}  // namespace
}  // namespace sonoskin
