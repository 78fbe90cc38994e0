#include "core/base/processors.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <fstream>

#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;

// Groups as a system has them, in a folder.
class Processors : public ::testing::Test {
 protected:
  void write(const fs::path& name, const std::string& text) {
    fs::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name) << text << '\n';
  }
  double quota() { return quotaOfGroups(folder_.path() / "groups", folder_.path() / "root"); }

  test::TempFolder folder_;
};

TEST_F(Processors, AreNotLimitedWhereNothingSaysSo) {
  EXPECT_GT(quota(), 1e6);
  write("groups", "0::/user/shell");
  write("root/user/shell/cpu.max", "max 100000");
  EXPECT_GT(quota(), 1e6);
  write("groups", "1:cpu,cpuacct:/box");
  write("root/cpu/box/cpu.cfs_quota_us", "-1");
  write("root/cpu/box/cpu.cfs_period_us", "100000");
  EXPECT_GT(quota(), 1e6);
  write("groups", "no groups at all");
  EXPECT_GT(quota(), 1e6);
}

TEST_F(Processors, ArePaidForByTheGroupOrOneAboveIt) {
  write("groups", "0::/user/shell");
  write("root/user/shell/cpu.max", "350000 100000");
  EXPECT_NEAR(quota(), 3.5, 1e-12);
  write("root/user/cpu.max", "100000 50000");
  EXPECT_NEAR(quota(), 2, 1e-12);
}

TEST_F(Processors, ArePaidForInTheFirstVersionOfGroups) {
  write("groups", "7:memory:/other\n4:cpuacct,cpu:/box");
  write("root/cpu/box/cpu.cfs_quota_us", "150000");
  write("root/cpu/box/cpu.cfs_period_us", "100000");
  EXPECT_NEAR(quota(), 1.5, 1e-12);
}

// Inside a container the mount is the group, whatever path it has outside.
TEST_F(Processors, ArePaidForByAGroupThatIsMountedAsAll) {
  write("groups", "0::/outside/4711");
  write("root/cpu.max", "200000 100000");
  EXPECT_NEAR(quota(), 2, 1e-12);
}

TEST_F(Processors, AreThoseThatTheProcessMayRunOn) {
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  CPU_ZERO(&one);
  for (int p = 0; p < CPU_SETSIZE; ++p)
    if (CPU_ISSET(p, &before)) {
      CPU_SET(p, &one);
      break;
    }
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  const int available = availableProcessors();
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(available, 1);
  EXPECT_GE(availableProcessors(), 1);
  EXPECT_LE(availableProcessors(), CPU_COUNT(&before));
}

}  // namespace
}  // namespace sonoskin
