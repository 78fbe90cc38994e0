// A session whose surface is older than the parameters opens as it was.
#include <gtest/gtest.h>

#include "core/io/file_bytes.h"
#include "core/io/volume_writer.h"
#include "core/mesh/mesh.h"
#include "core/phantom/phantom.h"
#include "tests/app/session_support.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::tinySurface;
using test::wait;

// A surface, and what was changed afterwards that it does not follow.
void makeOlder(Session& session) {
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  session.followParameters(false);
  Parameters parameters = session.parameters();
  parameters.classification.beta = 3.5;
  session.edit(parameters);
  session.erase(test::ballOnTheSurface(session));
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.state(), DocumentState::older);
}

TEST(OlderSurface, IsMadeFromWhatItWasMadeFrom) {
  const test::TempFolder folder;
  writeScan(folder / "scan.nrrd", makePhantomScan(tinySurface().phantom));
  Session session(tinySurface());
  session.openFile(folder / "scan.nrrd");
  ASSERT_TRUE(wait(session));
  ASSERT_NO_FATAL_FAILURE(makeOlder(session));
  session.saveSession(folder / "a.sonoskin", "{}");
  ASSERT_TRUE(wait(session));

  Session again(tinySurface());
  again.openSession(folder / "a.sonoskin");
  ASSERT_TRUE(wait(again));
  ASSERT_TRUE(again.results().mesh);
  EXPECT_EQ(again.state(), DocumentState::older) << "not made of the present parameters";
  EXPECT_EQ(again.results().mesh->positions, session.results().mesh->positions);
  EXPECT_EQ(again.results().classified->data, session.results().classified->data)
      << "that is of the present ones";
  EXPECT_EQ(again.parameters().classification.beta, 3.5);
  EXPECT_EQ(again.erased().voxels(), session.erased().voxels());
  EXPECT_FALSE(again.hasUnsavedWork());
  EXPECT_EQ(writeSessionFile(again.capture("{}")()), readText(folder / "a.sonoskin", kMostSessionBytes));

  again.reconstruct();
  ASSERT_TRUE(wait(again));
  EXPECT_EQ(again.state(), DocumentState::current);
  EXPECT_TRUE(again.capture("{}")().surface.empty());
}

}  // namespace
}  // namespace sonoskin
