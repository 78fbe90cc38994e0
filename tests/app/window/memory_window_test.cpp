// What one document took is the next one's.
#include <fstream>
#include <utility>

#include "app/workspace/session_actions.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

// Megabytes that the program has in memory.
double residentMegabytes() {
  std::ifstream facts("/proc/self/statm");
  double all = 0, resident = 0;
  facts >> all >> resident;
  return resident * 4096 / 1e6;
}

class MemoryWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(driver->waitUntilIdle());
  }
  fs::path scan(int seed) {
    Parameters parameters = smallPhantom();
    parameters.phantom.seed = seed;
    parameters.phantom.dims = {234, 128, 62};
    const fs::path file = folder / (std::to_string(seed) + ".nrrd");
    writeScan(file, makePhantomScan(parameters.phantom));
    return file;
  }
  double open(const fs::path& file) {
    Driver& d = *driver;
    openAny(d.workspace(), file);
    if (const auto asked = std::exchange(d.workspace().question, {})) asked->action();
    EXPECT_TRUE(d.wait([&] { return d.session().source() == file; }));
    EXPECT_TRUE(d.waitUntilIdle());
    d.frames(3);
    return residentMegabytes();
  }
  double makeSkin() {
    Driver& d = *driver;
    const std::uint64_t before = d.session().reconstructions();
    d.session().reconstruct();
    EXPECT_TRUE(d.wait([&] { return d.session().reconstructions() > before; }));
    EXPECT_TRUE(d.waitUntilIdle());
    EXPECT_TRUE(d.wait([&] { return d.workspace().view.skin.status.settled; }));
    d.frames(3);
    return residentMegabytes();
  }
};

TEST_F(MemoryWindowTest, GoesBackWhenAnotherFileIsOpened) {
  const double opened = open(scan(1)), withSkin = makeSkin(), other = open(scan(2));
  EXPECT_LT(other, opened + 100) << "with skin it was " << withSkin;
}

}  // namespace
}  // namespace sonoskin
