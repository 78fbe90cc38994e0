#include "app/workspace/autosave_slot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <utility>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr auto kKept = std::chrono::hours(24 * 30);

// Whether this program has the lock now, and the name is still that of the file that it locked: another one may have taken
// both away in between.
bool tryLock(const fs::path& lock, int descriptor) {
  struct stat named {
  }, opened{};
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::stat(lock.c_str(), &named) == 0 &&
         ::fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino;
}

fs::file_time_type timeOf(const fs::path& file) {
  std::error_code code;
  const fs::file_time_type time = fs::last_write_time(file, code);
  return code ? fs::file_time_type::min() : time;
}

bool isKept(const fs::path& file) {
  std::error_code code;
  return fs::is_regular_file(fs::symlink_status(file, code)) &&
         fs::file_time_type::clock::now() - timeOf(file) < kKept;
}

}  // namespace

fs::path stateFolder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state) return fs::path(state) / "sonoskin";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".local/state/sonoskin";
  return {};
}

AutosaveSlot::AutosaveSlot(fs::path lock, int descriptor)
    : lock_(std::move(lock)),
      file_(fs::path(lock_).replace_extension(".sonoskin")),
      descriptor_(descriptor) {}

// A lock that is not held yet looks like one that was left: whoever looks just then takes it away, and another is made.
AutosaveSlot::AutosaveSlot(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  fs::permissions(folder, fs::perms::owner_all, code);
  constexpr int kTries = 10;
  for (int n = 0; n < kTries; ++n) {
    std::string name = (folder / "window-XXXXXX.lock").string();
    const int descriptor = ::mkostemps(name.data(), 5, O_CLOEXEC);
    if (descriptor < 0) break;
    if (tryLock(name, descriptor)) {
      AutosaveSlot made(name, descriptor);
      swap(made);
      return;
    }
    ::close(descriptor);
  }
  throw Error(
      fmt::format(
          "What is open is not kept in case of a crash, for {} cannot be written; mend its permissions.",
          folder.string()),
      Error::Kind::system);
}

void AutosaveSlot::swap(AutosaveSlot& other) noexcept {
  std::swap(lock_, other.lock_);
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
}

void AutosaveSlot::leave() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

// The lock goes last: whoever finds it alone finds nothing to keep.
void AutosaveSlot::remove() {
  if (descriptor_ < 0) return;
  std::error_code code;
  fs::remove(file_, code);
  fs::remove(lock_, code);
  leave();
}

std::vector<AutosaveSlot> AutosaveSlot::left(const fs::path& folder) {
  std::vector<AutosaveSlot> slots;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, code)) {
    if (entry.path().extension() == ".sonoskin" && !isKept(entry.path())) fs::remove(entry.path(), code);
    if (entry.path().extension() != ".lock") continue;
    const int descriptor = ::open(entry.path().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) continue;
    AutosaveSlot slot(entry.path(), descriptor);
    if (!tryLock(slot.lock_, descriptor)) {
      slot.leave();
    } else if (isKept(slot.file_)) {
      slots.push_back(std::move(slot));
    }
  }
  std::ranges::sort(
      slots, [](const AutosaveSlot& a, const AutosaveSlot& b) { return timeOf(a.file_) > timeOf(b.file_); });
  return slots;
}

}  // namespace sonoskin
