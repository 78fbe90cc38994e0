// A whole session by events alone: no window, no display, no mouse.
#include "tests/app/injected_player.h"
#include "tests/app/session_script.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::test {
namespace {

TEST(WholeSession, ByInjectedEventsWithoutAWindow) {
  const TempFolder folder;
  setenv("XDG_CONFIG_HOME", (folder.path() / "settings").c_str(), 1);
  setenv("XDG_STATE_HOME", (folder.path() / "state").c_str(), 1);
  unsetenv("DISPLAY");
  InjectedPlayer player(scriptParameters());
  player.folder = folder.path();
  beginScript(player);
  for (const ScriptPiece& piece : sessionScript()) {
    SCOPED_TRACE(piece.name);
    ASSERT_NO_FATAL_FAILURE(piece.play(player));
  }
  quitAndReopen(player);
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

}  // namespace
}  // namespace sonoskin::test
