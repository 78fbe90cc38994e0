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

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::ballOnTheSurface;
using test::tinyPhantom;
using test::wait;

TEST(Session, KnowsWhatWouldBeLost) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasUnsavedWork());
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.hasUnsavedWork());
  const fs::path file = fs::temp_directory_path() / "sonoskin_session_unsaved.ply";
  session.saveMesh(file);
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasUnsavedWork());
  session.followParameters(false);  // the surface stays the one that is saved
  session.erase(ballOnTheSurface(session));
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  ASSERT_GT(session.erased().voxels(), 0u);
  EXPECT_TRUE(session.hasUnsavedWork());
  const fs::path erased = fs::temp_directory_path() / "sonoskin_session_unsaved.erased.nrrd";
  session.saveErased(erased);
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasUnsavedWork());
  fs::remove(erased);
  fs::remove(file);
  fs::remove(fs::path(file).replace_extension(".recipe.json"));
}

// A file of somebody else's that has the recipe's name is left alone, and said so.
TEST(Session, LeavesForeignFilesBesideAnExportAlone) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  const fs::path folder = fs::temp_directory_path() / "sonoskin_session_foreign";
  fs::remove_all(folder);
  fs::create_directories(folder);
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
  fs::remove_all(folder);
}

TEST(Session, ErasedPartsAreSavedAndOpenedAgain) {
  const fs::path file = fs::temp_directory_path() / "sonoskin_session_test.erased.nrrd";
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
  fs::remove(file);
}

TEST(Session, SavesASolidForPrinting) {
  Session session(tinyPhantom());
  EXPECT_THROW(session.savePrint("nothing.stl"), Error);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  Parameters small = session.parameters();
  small.mesh.resolution = 60;
  small.surface.minClusterArea = 20;
  session.edit(small);
  session.commitEdit();
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  session.takeMessages();
  const fs::path file = fs::temp_directory_path() / "sonoskin_session_test.stl";
  session.savePrint(file);
  EXPECT_TRUE(session.saving());
  ASSERT_TRUE(wait(session));
  const std::vector<Message> messages = session.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].kind, Message::Kind::note) << messages[0].text;
  EXPECT_TRUE(measureMesh(readMesh(file)).printable());
  fs::remove(file);
  fs::remove(fs::path(file).replace_extension(".recipe.json"));
}

TEST(Session, SavesTheRecipeBesideTheMeshAndReadsItAgain) {
  Session session(tinyPhantom());
  EXPECT_THROW(session.saveMesh("nothing.ply"), Error);
  const fs::path file = fs::temp_directory_path() / "sonoskin_session_test.recipe.json";
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
