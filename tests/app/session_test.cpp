#include "app/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/base/timer.h"
#include "core/io/mesh_reader.h"
#include "core/io/volume_writer.h"
#include "core/mesh/mesh_facts.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/phantom_landmarks.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;

Parameters tinyPhantom() {
  Parameters parameters;
  parameters.phantom.dims = {78, 43, 31};
  return parameters;
}

// wait: polls until the session rests; false after a minute.
bool wait(Session& session) {
  const Timer timer;
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    session.poll();
    if (timer.seconds() > 60) return false;
  } while (session.activity().busy);
  session.poll();
  return true;
}

TEST(Session, ClassifiesWhatItOpens) {
  Session session(tinyPhantom());
  EXPECT_FALSE(session.hasScan());
  session.openPhantom();
  EXPECT_TRUE(session.activity().busy);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.name(), "Phantom");
  ASSERT_TRUE(session.results().classified);
  EXPECT_FALSE(session.classifiedIsCoarse());
  EXPECT_GT(session.results().isoValue, 0);
  EXPECT_EQ(session.proposedName(".ply"), "surface.ply");
}

// The default top is on the axis of two of the sides: beams are there all the same, whatever is chosen after what.
TEST(Session, HasBeamsForEveryChoiceOfSides) {
  Geometry g;
  g.dims = {24, 24, 24};
  Volume<float> noise(g);
  for (std::size_t v = 0; v < noise.data.size(); ++v) noise.data[v] = 0.01f * float(v % 97);
  const fs::path file = fs::temp_directory_path() / "sonoskin_session_sides.nrrd";
  writeVolume(file, noise);
  Session session(tinyPhantom());
  session.openFile(file);
  ASSERT_TRUE(wait(session));
  for (int probe = 0; probe < 6; ++probe)
    for (int top = 0; top < 6; ++top) {
      Parameters parameters = session.parameters();
      parameters.scan.probeSide = VolumeSide(probe);
      session.edit(parameters);
      EXPECT_NO_THROW(session.beam());
      EXPECT_EQ(session.parameters().scan.probeSide, VolumeSide(probe));
      parameters = session.parameters();
      parameters.scan.topSide = VolumeSide(top);
      session.edit(parameters);
      EXPECT_NO_THROW(session.beam());
      EXPECT_EQ(session.parameters().scan.topSide, VolumeSide(top));
      EXPECT_NEAR(glm::dot(session.beam().axis, session.beam().up), 0, 1e-9);
      parameters.scan.probeSide = parameters.scan.topSide = VolumeSide(top);  // as a recipe may have it
      session.edit(parameters);
      EXPECT_NO_THROW(session.beam());
    }
  fs::remove(file);
}

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
  session.erase({});
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  const bool erased = session.erased().voxels() > 0;
  EXPECT_TRUE(session.hasUnsavedWork() || !erased);
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

TEST(Session, WarnsOnceOfAScanThatIsNoSkinAndAgainWhenItsSurfaceIsAskedFor) {
  Geometry g;
  g.dims = {48, 48, 48};
  g.spacing = glm::dvec3(2);
  Volume<float> ball(g);  // as sharp all around
  for (int k = 0; k < 48; ++k)
    for (int j = 0; j < 48; ++j)
      for (int i = 0; i < 48; ++i) {
        const float d = 2 * glm::length(glm::vec3(i, j, k) - glm::vec3(23.5f));
        ball.at(i, j, k) = (d > 36 ? 0.02f : 0.5f) + 0.001f * float((7 * i + 11 * j + 13 * k) % 10);
      }
  const fs::path file = fs::temp_directory_path() / "sonoskin_session_warning.nrrd";
  writeVolume(file, ball);
  Session session(tinyPhantom());
  session.openFile(file);
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.warnings().size(), 1u);
  const auto warned = [&] {
    const std::vector<Message> messages = session.takeMessages();
    return std::count_if(messages.begin(), messages.end(), [&](const Message& m) {
      return m.kind == Message::Kind::warning && m.text == session.warnings()[0];
    });
  };
  EXPECT_EQ(warned(), 1);
  Parameters moved = session.parameters();
  moved.surface.minClusterArea = 40;
  session.edit(moved);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.warnings().size(), 1u);
  EXPECT_EQ(warned(), 0) << "a slider does not repeat it";
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.results().mesh);
  EXPECT_EQ(warned(), 1);
  fs::remove(file);
}

TEST(Session, UndoBringsParametersAndResultsBack) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
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
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  Parameters small = session.parameters();
  small.mesh.resolution = 60;
  small.surface.minClusterArea = 20;
  session.edit(small);
  session.commitEdit();
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.results().mesh);
  EXPECT_TRUE(session.meshIsCurrent());
  EXPECT_GT(session.meshArea(), 100);
  EXPECT_EQ(session.reconstructions(), 1u);

  Parameters other = small;
  other.classification.alpha = 2;
  session.edit(other);
  EXPECT_FALSE(session.meshIsCurrent());
  session.edit(small);
  EXPECT_TRUE(session.meshIsCurrent());
}

TEST(Session, TheSurfaceFollowsTheParametersOnceThereIsOne) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  Parameters p = session.parameters();
  p.mesh.resolution = 60;
  p.surface.minClusterArea = 20;
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

// The middle of the points, and a ball around it.
Brush ballOnTheSurface(const Session& session) {
  const auto& positions = session.results().points->positions;
  const glm::dvec3 at(positions[positions.size() / 2]);
  return {at, at, 12, true};
}

TEST(Session, AStrokeTakesPointsAwayAndUndoBringsThemBack) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
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
  Parameters small = tinyPhantom();
  small.mesh.resolution = 60;
  small.surface.minClusterArea = 20;
  Session session(small);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.meshIsCurrent());
  session.erase(ballOnTheSurface(session));
  session.commitEdit();
  EXPECT_FALSE(session.meshIsCurrent());
  session.undo();
  EXPECT_TRUE(session.meshIsCurrent());
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

// What only pictures depend on makes nothing anew, but can be undone and is saved.
TEST(Session, SkinLightAndLandmarksChangePicturesAlone) {
  Parameters small = tinyPhantom();
  small.mesh.resolution = 60;
  small.surface.minClusterArea = 20;
  Session session(small);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
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

  const fs::path file = fs::temp_directory_path() / "sonoskin_session_test.recipe.json";
  session.saveRecipe(file);
  ASSERT_TRUE(wait(session));
  session.undo();
  session.loadRecipe(file);
  EXPECT_EQ(session.parameters().light.azimuth, 120);
  EXPECT_FALSE(session.activity().busy);
  EXPECT_EQ(session.results().mesh, mesh);
  fs::remove(file);
}

// Landmarks are places on one face.
TEST(Session, ThePhantomBringsItsLandmarksAndAnotherScanHasNone) {
  const fs::path file = fs::temp_directory_path() / "sonoskin_session_test.nrrd";
  Parameters given = tinyPhantom();
  given.landmarks.noseTip = {7, 8, 9};
  Session session(given);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.parameters().landmarks, given.landmarks) << "what was given counts";

  given.phantom.seed = 2;
  session.edit(given);
  session.commitEdit();
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.parameters().landmarks, phantomLandmarks());
  EXPECT_FALSE(session.canUndo()) << "the places before were of another scan";

  writeScan(file, makePhantomScan([] {
              PhantomOptions other;
              other.dims = {78, 43, 31};
              other.seed = 3;
              return other;
            }()));
  session.openFile(file);
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.name(), file.filename());
  EXPECT_EQ(session.parameters().landmarks, LandmarkOptions{});
  fs::remove(file);
}

// Both belong to their volume.
TEST(Session, AnotherVolumeHasNoCropBoxAndNothingErased) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.erase(ballOnTheSurface(session));
  Parameters cut = session.parameters();
  cut.region.cutLow[0] = 20;
  cut.phantom.dims = {60, 43, 31};
  session.edit(cut);
  session.commitEdit();
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.erased().voxels(), 0u);
  EXPECT_EQ(session.parameters().region.cutLow[0], 0);
  EXPECT_EQ(session.parameters().phantom.dims, (std::array<int, 3>{60, 43, 31}));
  EXPECT_FALSE(session.canUndo());
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
  EXPECT_DOUBLE_EQ(other.parameters().classification.gamma, 0.5);
  EXPECT_TRUE(other.canUndo());
  fs::remove(file);
  EXPECT_THROW(other.loadRecipe(file), Error);
}

TEST(Session, TellsWhatCannotBeOpenedAndKeepsWhatItHas) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  const Key key = session.scan().key;
  session.openFile("/nowhere/at/all.nrrd");
  ASSERT_TRUE(wait(session));
  const std::vector<Message> messages = session.takeMessages();
  ASSERT_FALSE(messages.empty());
  EXPECT_EQ(messages.back().kind, Message::Kind::failure);
  EXPECT_EQ(session.scan().key, key);
}

TEST(Session, SpacingCanBeSet) {
  Session session(tinyPhantom());
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.setSpacing({0.5, 0.6, 0.7});
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.scan().volume->geometry.spacing, glm::dvec3(0.5, 0.6, 0.7));
  EXPECT_EQ(session.results().classified->geometry.spacing, glm::dvec3(0.5, 0.6, 0.7));
}

}  // namespace
}  // namespace sonoskin
