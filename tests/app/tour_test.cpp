#include "app/workspace/tour.h"

#include <gtest/gtest.h>

#include "app/workspace/commands.h"
#include "app/workspace/workspace.h"
#include "tests/app/session_support.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

TEST(Tour, GoesThroughFiveStepsAndBack) {
  Workspace workspace{Parameters()};
  EXPECT_FALSE(isEnabled(command("help.tourNext"), workspace));
  ASSERT_EQ(tourCards().size(), 5u);
  command("help.tour").run(workspace);
  EXPECT_TRUE(workspace.session.activity().busy) << "the phantom is not opened";
  for (std::size_t n = 0; n < 5; ++n) {
    ASSERT_TRUE(onTour(workspace)) << n;
    EXPECT_EQ(*workspace.help.tour, n);
    EXPECT_EQ(canGoBack(workspace), n > 0);
    command("help.tourNext").run(workspace);
    if (n == 2) {
      command("help.tourBack").run(workspace);
      EXPECT_EQ(*workspace.help.tour, 2u);
      command("help.tourNext").run(workspace);
    }
  }
  EXPECT_FALSE(onTour(workspace));
}

TEST(Tour, KeepsThePhantomThatIsThere) {
  Parameters small;
  small.phantom.dims = {40, 30, 20};
  Workspace workspace{small};
  workspace.session.openPhantom();
  ASSERT_TRUE(test::wait(workspace.session));
  const std::uint64_t opened = workspace.session.opened();
  startTour(workspace);
  EXPECT_TRUE(onTour(workspace));
  ASSERT_TRUE(test::wait(workspace.session));
  EXPECT_EQ(workspace.session.opened(), opened);
}

TEST(Tour, IsOfferedOnce) {
  const test::TempFolder folder;
  Workspace first{Parameters()};
  first.settings = readSettings(folder / "settings.json");
  offerTour(first);
  EXPECT_TRUE(first.help.offered);
  writeSettings(folder / "settings.json", first.settings);
  Workspace second{Parameters()};
  second.settings = readSettings(folder / "settings.json");
  offerTour(second);
  EXPECT_FALSE(second.help.offered);
}

}  // namespace
}  // namespace sonoskin
