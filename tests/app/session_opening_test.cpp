// What a session opens, and what it says of it.
#include "app/document/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/phantom_landmarks.h"
#include "tests/app/session_support.h"
#include "tests/support/kretz.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::ballOnTheSurface;
using test::OpenSession;
using test::TempFolder;
using test::tinyPhantom;
using test::wait;

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

// Of two volumes in one file nothing is opened until the person has chosen.
TEST(Session, AsksWhichOfSeveralVolumesIsOpened) {
  const TempFolder folder;
  std::string grey, colour;
  for (int n = 0; n < 24 * 24 * 24; ++n) {
    grey += char(n % 97);
    colour += char(n % 89);
  }
  test::KretzWriter kretz;
  kretz.dims(24, 24, 24).values(0xC100, 1, {0.001}).record(0xD000, 1, grey);
  kretz.dims(24, 24, 24, 1).values(0xC100, 0x101, {0.002}).record(0xD000, 0x101, colour).end();
  const fs::path file = folder.write("two.vol", kretz.bytes());
  Session session(tinyPhantom());
  session.openFile(file);
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.hasScan());
  EXPECT_TRUE(session.takeMessages().empty());
  const auto choice = session.takeChoice();
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->volumes.size(), 2u);
  session.openVolume(*choice, 2);
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.hasScan());
  EXPECT_FALSE(session.takeChoice());
  EXPECT_NEAR(session.scan().volume->geometry.spacing.x, 2, 1e-9);
  EXPECT_EQ(session.parameters().scan.volume, 2);
}

// The default top is on the axis of two of the sides: beams are there all the same, whatever is chosen after what.
TEST(Session, HasBeamsForEveryChoiceOfSides) {
  Geometry g;
  g.dims = {24, 24, 24};
  Volume<float> noise(g);
  for (std::size_t v = 0; v < noise.data.size(); ++v) noise.data[v] = 0.01f * float(v % 97);
  const TempFolder folder;
  const fs::path file = folder / "sides.nrrd";
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
  const TempFolder folder;
  const fs::path file = folder / "warning.nrrd";
  writeVolume(file, ball);
  LogRecord said;
  Session session(tinyPhantom());
  session.openFile(file);
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.warnings().size(), 1u);
  const auto warned = [&] {
    const std::vector<LogEntry> entries = said.take();
    return std::count_if(entries.begin(), entries.end(), [&](const LogEntry& e) {
      return e.level == LogLevel::warning && e.sentence == asSentence(session.warnings()[0]);
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
}

// Landmarks are places on one face.
TEST(Session, ThePhantomBringsItsLandmarksAndAnotherScanHasNone) {
  Parameters given = tinyPhantom();
  given.landmarks.noseTip = {7, 8, 9};
  OpenSession session(given);
  EXPECT_EQ(session.parameters().landmarks, given.landmarks) << "what was given counts";

  given.phantom.seed = 2;
  session.edit(given);
  session.commitEdit();
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.parameters().landmarks, phantomLandmarks());
  EXPECT_FALSE(session.canUndo()) << "the places before were of another scan";

  const TempFolder folder;
  const fs::path file = folder / "other.nrrd";
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
}

// Both belong to their volume.
TEST(Session, AnotherVolumeHasNoCropBoxAndNothingErased) {
  OpenSession session;
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

// The older document's volume and all that was made of it: its memory is the next one's.
TEST(Session, AnotherDocumentTakesTheOldersPlace) {
  Parameters small = tinyPhantom();
  small.mesh.resolution = 60;
  small.surface.minClusterArea = 20;
  Session session(small);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.results().mesh);
  const std::weak_ptr<const Volume<float>> volume = session.scan().volume;
  const std::weak_ptr<const Volume<float>> classified = session.results().classified;
  const std::weak_ptr<const SurfacePoints> points = session.results().points;
  const std::weak_ptr<const Mesh> mesh = session.results().mesh;
  small = session.parameters();
  small.phantom.seed = 2;
  session.edit(small);
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.results().points);
  EXPECT_FALSE(session.results().mesh);
  EXPECT_TRUE(volume.expired());
  EXPECT_TRUE(classified.expired());
  EXPECT_TRUE(points.expired());
  EXPECT_TRUE(mesh.expired());
}

TEST(Session, TellsWhatCannotBeOpenedAndKeepsWhatItHas) {
  OpenSession session;
  const Key key = session.scan().key;
  session.openFile("/nowhere/at/all.nrrd");
  ASSERT_TRUE(wait(session));
  const std::vector<Message> messages = session.takeMessages();
  ASSERT_FALSE(messages.empty());
  EXPECT_EQ(messages.back().kind, Message::Kind::failure);
  EXPECT_EQ(session.scan().key, key);
}

// A ball in a file that does not say how large its voxels are.
fs::path fileWithoutSpacing(const TempFolder& folder, const char* name) {
  std::string bytes = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 24 24 24\nencoding: raw\n\n";
  for (int v = 0; v < 24 * 24 * 24; ++v) {
    const glm::vec3 at(v % 24, v / 24 % 24, v / 576);
    bytes += char(glm::length(at - 11.5f) < 7 ? 100 : 10 + v % 3);
  }
  return folder.write(name, bytes);
}

void setSpacing(Session& session, const std::array<double, 3>& spacing) {
  Parameters parameters = session.parameters();
  parameters.scan.spacing = spacing;
  session.edit(parameters);
  session.commitEdit();
}

TEST(Session, SpacingIsAParameterWhereTheFileGivesNone) {
  const TempFolder folder;
  Session session(tinyPhantom());
  session.openFile(fileWithoutSpacing(folder, "a.nrrd"));
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.givesSpacing() || session.scan().spacingKnown);
  setSpacing(session, {0.5, 0.6, 0.7});
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.scan().volume->geometry.spacing, glm::dvec3(0.5, 0.6, 0.7));
  EXPECT_EQ(session.results().classified->geometry.spacing, glm::dvec3(0.5, 0.6, 0.7));
  EXPECT_TRUE(session.scan().spacingKnown);
  session.undo();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.scan().volume->geometry.spacing, glm::dvec3(1));
  EXPECT_FALSE(session.scan().spacingKnown);
  session.redo();
  ASSERT_TRUE(wait(session));

  // What was typed for one file is not the next one's.
  session.openFile(fileWithoutSpacing(folder, "b.nrrd"));
  ASSERT_TRUE(wait(session));
  EXPECT_FALSE(session.scan().spacingKnown);
  EXPECT_EQ(session.parameters().scan.spacing, ScanOptions().spacing);
}

TEST(Session, AFileThatGivesItsSpacingKeepsIt) {
  OpenSession session;
  const glm::dvec3 spacing = session.scan().volume->geometry.spacing;
  setSpacing(session, {0.5, 0.6, 0.7});
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.givesSpacing());
  EXPECT_EQ(session.scan().volume->geometry.spacing, spacing);
}

}  // namespace
}  // namespace sonoskin
