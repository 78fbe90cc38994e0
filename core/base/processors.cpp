#include "core/base/processors.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr double kUnlimited = 1e9;

// The first number of a file, or nothing below 0 where it has none: "max" is one of those.
double firstNumber(const fs::path& file) {
  double number = -1;
  std::ifstream(file) >> number;
  return number;
}

// What one group pays for, in the second version of groups or the first.
double quotaOf(const fs::path& group) {
  double quota = -1, period = -1;
  std::ifstream second(group / "cpu.max");
  if (second >> quota >> period && quota > 0 && period > 0) return quota / period;
  quota = firstNumber(group / "cpu.cfs_quota_us");
  period = firstNumber(group / "cpu.cfs_period_us");
  return quota > 0 && period > 0 ? quota / period : kUnlimited;
}

// From a group up to where they are mounted. Within a container the mount may itself be the group.
double leastUpward(const fs::path& root, fs::path group) {
  double least = quotaOf(root);
  for (group = group.relative_path(); !group.empty(); group = group.parent_path())
    least = std::min(least, quotaOf(root / group));
  return least;
}

}  // namespace

double quotaOfGroups(const fs::path& groups, const fs::path& root) {
  double least = kUnlimited;
  std::ifstream lines(groups);
  // Lines such as "0::/user/shell" of the second version, "4:cpu,cpuacct:/shell" of the first.
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string kinds = "," + line.substr(first + 1, second - first - 1) + ",";
    const fs::path group = line.substr(second + 1);
    if (kinds == ",,") least = std::min(least, leastUpward(root, group));
    if (kinds.find(",cpu,") != std::string::npos) least = std::min(least, leastUpward(root / "cpu", group));
  }
  return least;
}

int availableProcessors() {
  cpu_set_t mayRunOn;
  const bool known = ::sched_getaffinity(0, sizeof mayRunOn, &mayRunOn) == 0;
  const double allowed = known ? CPU_COUNT(&mayRunOn) : std::max(1u, std::thread::hardware_concurrency());
  const double paid = std::ceil(quotaOfGroups("/proc/self/cgroup", "/sys/fs/cgroup") - 1e-6);
  return int(std::clamp(paid, 1.0, allowed));
}

}  // namespace sonoskin
