#include "core/base/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace sonoskin {
namespace {

constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

// The number behind a word in a file of lines; with an empty word the first one. "max" is no number.
std::size_t numberIn(const std::string& path, const std::string& word) {
  std::ifstream file(path);
  std::string name;
  std::size_t number = 0;
  if (word.empty()) return file >> number ? number : kUnknown;
  while (file >> name)
    if (name == word) return file >> number ? number : kUnknown;
  return kUnknown;
}

// What is left of the limit of the control group in which the program sees itself, as in a container.
std::size_t leftInGroup() {
  const std::string group = "/sys/fs/cgroup/";
  const std::size_t limit = numberIn(group + "memory.max", ""), used = numberIn(group + "memory.current", "");
  if (limit == kUnknown || used == kUnknown) return kUnknown;
  const std::size_t cache = numberIn(group + "memory.stat", "inactive_file");  // given back when it is wanted
  const std::size_t kept = used - std::min(used, cache == kUnknown ? 0 : cache);
  return limit - std::min(limit, kept);
}

// What is left of the addresses that the process may use (ulimit -v).
std::size_t leftOfAddresses() {
  rlimit limit{};
  const std::size_t pages = numberIn("/proc/self/statm", "");
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || pages == kUnknown)
    return kUnknown;
  return limit.rlim_cur - std::min<std::size_t>(limit.rlim_cur, pages * std::size_t(::sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::size_t availableMemory() {
  constexpr std::size_t kKilobyte = 1024;
  const std::size_t free = numberIn("/proc/meminfo", "MemAvailable:");
  return std::min({free == kUnknown ? kUnknown : free * kKilobyte, leftInGroup(), leftOfAddresses()});
}

}  // namespace sonoskin
