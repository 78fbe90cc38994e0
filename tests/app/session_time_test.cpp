// Recordings in time: one document, a scan for each time step.
#include <gtest/gtest.h>

#include "core/io/mesh_reader.h"
#include "core/pipeline/phantom_landmarks.h"
#include "tests/app/session_support.h"
#include "tests/support/program.h"
#include "tests/support/recording.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::TempFolder;
using test::tinySurface;
using test::wait;
using test::writeRecording;

// OpenRecording: a session that has three time steps open, and rests.
struct OpenRecording : Session {
  explicit OpenRecording(const TempFolder& folder) : Session(tinySurface()) {
    writeRecording(folder / "three.nrrd", tinySurface().phantom, 3);
    openFile(folder / "three.nrrd");
    EXPECT_TRUE(wait(*this));
  }
  void goTo(int time) {
    Parameters parameters = this->parameters();
    parameters.scan.time = time;
    edit(parameters);
    commitEdit();
    EXPECT_TRUE(wait(*this));
  }
};

TEST(SessionTime, AnotherStepKeepsTheDocument) {
  const TempFolder folder;
  OpenRecording session(folder);
  EXPECT_EQ(session.scan().timeSteps, 3);
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  const auto mesh = session.results().mesh;
  const Key first = session.scan().key;
  Parameters parameters = session.parameters();
  parameters.landmarks.noseTip = {1, 2, 3};
  session.edit(parameters);
  session.erase(test::ballOnTheSurface(session));
  session.commitEdit();
  const std::size_t erased = session.erased().voxels();
  const std::uint64_t opened = session.opened();

  session.goTo(3);
  EXPECT_TRUE(session.isAtTime());
  EXPECT_EQ(session.scan().time, 3);
  EXPECT_FALSE(session.scan().key == first);
  EXPECT_EQ(session.opened(), opened);
  EXPECT_EQ(session.parameters().landmarks.noseTip[2], 3);
  EXPECT_EQ(session.erased().voxels(), erased);
  ASSERT_TRUE(session.results().mesh);
  EXPECT_NE(session.results().mesh, mesh);
  EXPECT_TRUE(session.meshIsCurrent());

  session.undo();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.scan().time, 1);
  EXPECT_TRUE(session.scan().key == first);
}

TEST(SessionTime, AStepThatIsCancelledLeavesTheOneThatIs) {
  const TempFolder folder;
  OpenRecording session(folder);
  Parameters parameters = session.parameters();
  parameters.scan.time = 3;
  session.edit(parameters);
  session.cancel();
  EXPECT_TRUE(session.isAtTime());
  EXPECT_EQ(session.parameters().scan.time, 1);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.scan().time, 1);
  session.goTo(3);
  EXPECT_EQ(session.scan().time, 3) << "it can be asked for again";
}

// A step that is not there is told once; the scan stays, and another step can be asked for.
TEST(SessionTime, AStepThatIsNotThereIsTold) {
  const TempFolder folder;
  OpenRecording session(folder);
  session.goTo(7);
  EXPECT_FALSE(session.isAtTime());
  const std::vector<Message> messages = session.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].text.find("no step 7"), std::string::npos) << messages[0].text;
  EXPECT_EQ(session.scan().time, 1);
  session.goTo(2);
  EXPECT_EQ(session.scan().time, 2);
  session.goTo(1);
  EXPECT_TRUE(session.isAtTime());
}

TEST(SessionTime, AnotherFileBeginsWithItsFirstStep) {
  const TempFolder folder;
  OpenRecording session(folder);
  session.goTo(3);
  writeRecording(folder / "two.nrrd", tinySurface().phantom, 2);
  session.openFile(folder / "two.nrrd");
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.takeMessages().empty());
  EXPECT_EQ(session.scan().timeSteps, 2);
  EXPECT_EQ(session.scan().time, 1);
  EXPECT_EQ(session.parameters().scan.time, 1);
}

// An axis that is turned over makes another scan at once, and turned back the same one; its landmarks are its own.
TEST(SessionTime, TurnsAnAxisOver) {
  const TempFolder folder;
  OpenRecording session(folder);
  const Scan before = session.scan();
  Parameters parameters = session.parameters();
  parameters.landmarks.noseTip = {1, 2, 3};
  parameters.scan.mirror = MirroredAxis::i;
  session.edit(parameters);
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.scan().volume->geometry.mirrors());
  EXPECT_FALSE(hasLandmarks(session.parameters().landmarks));
  session.goTo(2);
  EXPECT_TRUE(session.scan().volume->geometry.mirrors());
  session.goTo(1);
  parameters = session.parameters();
  parameters.scan.mirror = MirroredAxis::none;
  session.edit(parameters);
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(session.scan().key == before.key);
}

TEST(SessionTime, SavesASequenceOfMeshesWithOneRecipe) {
  const TempFolder folder;
  OpenRecording session(folder);
  std::filesystem::create_directory(folder / "out");
  session.saveSequence(folder / "out/face.ply", {2, 3});
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(test::filesBelow(folder / "out"),
            (std::vector<std::string>{"face.recipe.json", "face_0002.ply", "face_0003.ply"}));
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  session.goTo(2);
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(readMesh(folder / "out/face_0002.ply").positions, session.results().mesh->positions);
}

}  // namespace
}  // namespace sonoskin
