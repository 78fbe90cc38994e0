#include "core/io/staging.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/base/error_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPrefix = ".sonoskin-";
// The list of a set that is complete: the number that the file system gave the staging folder, so that one which was copied
// or unpacked here is not taken for ours; then lines "+name" for a file that gets its name, "-name" for one that goes.
constexpr const char *kJournal = ".sonoskin-publish", *kUnfinishedJournal = ".sonoskin-list";

template <class... Args>
[[noreturn]] void failOnDisk(fmt::format_string<Args...> sentence, Args&&... args) {
  throw Error(fmt::format(sentence, std::forward<Args>(args)...), Error::Kind::system);
}

// Folder: a folder that is open, for its lock; -1 where it cannot be opened.
class Folder {
 public:
  explicit Folder(const fs::path& path, int flags = 0)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | flags)) {}
  ~Folder() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  bool tryLock() const { return descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }
  // Waits a moment for another program that is about to make or remove a staging folder.
  bool lock() const {
    constexpr int kTries = 50;
    for (int i = 0; i < kTries; ++i) {
      if (tryLock()) return true;
      if (descriptor_ < 0 || errno != EWOULDBLOCK) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
    return false;
  }
  void flush() const {
    if (descriptor_ >= 0) ::fsync(descriptor_);
  }
  bool isOurs() const {
    struct stat facts;
    return descriptor_ >= 0 && ::fstat(descriptor_, &facts) == 0 && facts.st_uid == ::geteuid();
  }
  int release() { return std::exchange(descriptor_, -1); }

 private:
  int descriptor_;
};

std::string randomName() {
  std::uint64_t numbers[2];
  if (::getrandom(numbers, sizeof numbers, 0) != ssize_t(sizeof numbers))
    failOnDisk("The system gives no random numbers: {}.", systemCause(errno));
  return fmt::format("{}{:016x}{:016x}", kPrefix, numbers[0], numbers[1]);
}

// Of a staging folder.
bool isOwnName(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with(kPrefix) && name.size() == std::strlen(kPrefix) + 32 &&
         name.find_first_not_of("0123456789abcdef", std::strlen(kPrefix)) == std::string::npos;
}
bool isPlainName(const std::string& name) {
  const bool isWhole = name.find('\0') == std::string::npos;  // the system would end it there
  return isWhole && !name.empty() && name != "." && name != ".." &&
         fs::path(name).filename() == fs::path(name) && !name.starts_with(kPrefix);
}

bool isTakenByOther(const fs::path& target) {
  const fs::file_status status = fs::symlink_status(target);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_symlink(status);
}

void moveInto(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::rename(from, to, code);
  if (code) failOnDisk("{} could not be written: {}.", to.string(), systemCause(code.value()));
}

// Where a name leads: through a link to the file that it stands for.
fs::path resolved(const fs::path& target) {
  std::error_code code;
  if (!fs::is_symlink(fs::symlink_status(target, code))) return target;
  const fs::path real = fs::weakly_canonical(target, code);
  return code || real.empty() ? target : real;
}

// By a copy beside it, for a name on another file system.
void copyInto(const fs::path& from, const fs::path& to) {
  const fs::path beside = to.parent_path() / randomName();
  std::error_code code, ignored;
  fs::copy_file(from, beside, code);
  if (code) {
    fs::remove(beside, ignored);
    failOnDisk("{} could not be written: {}.", to.string(), systemCause(code.value()));
  }
  flushFile(beside);
  moveInto(beside, to);
  fs::remove(from, ignored);
}

// A file gets its name, and the permissions of the one that it replaces.
void giveName(const fs::path& from, const fs::path& target) {
  const fs::path to = resolved(target);
  std::error_code code;
  const fs::file_status old = fs::status(to, code);
  if (fs::is_regular_file(old)) fs::permissions(from, old.permissions(), code);
  fs::rename(from, to, code);
  if (code == std::errc::cross_device_link) return copyInto(from, to);
  if (code) failOnDisk("{} could not be written: {}.", target.string(), systemCause(code.value()));
}

std::string numberOf(const fs::path& folder) {
  struct stat facts;
  return ::stat(folder.c_str(), &facts) == 0 ? fmt::format("{}", facts.st_ino) : std::string();
}

bool isOwnJournal(const fs::path& staging) {
  std::ifstream journal(staging / kJournal, std::ios::binary);
  std::string number;
  return std::getline(journal, number) && !number.empty() && number == numberOf(staging);
}

void writeJournal(const fs::path& staging, const std::vector<std::string>& lines) {
  {
    std::ofstream journal(staging / kUnfinishedJournal, std::ios::binary);
    journal << numberOf(staging) << '\n';
    for (const std::string& line : lines) journal << line << '\n';
    journal.close();
    if (!journal)
      failOnDisk(
          "{} could not be written completely; the disk may be full, make room or choose another place.",
          staging.string());
  }
  flushFile(staging / kUnfinishedJournal);
  moveInto(staging / kUnfinishedJournal, staging / kJournal);
  Folder(staging).flush();
}

// Does what a journal says, as far as it has not been done.
void followJournal(const fs::path& staging, const fs::path& folder) {
  std::ifstream journal(staging / kJournal, std::ios::binary);
  std::string line;
  std::getline(journal, line);  // the folder's number
  while (std::getline(journal, line)) {
    const std::string name = line.empty() ? "" : line.substr(1);
    if (!isPlainName(name)) continue;
    std::error_code code;
    if (line[0] == '+' && fs::exists(staging / name, code)) giveName(staging / name, folder / name);
    if (line[0] == '-' && fs::is_regular_file(fs::symlink_status(folder / name, code)))
      fs::remove(folder / name, code);
  }
  Folder(folder).flush();
  std::error_code ignored;
  fs::remove(staging / kJournal, ignored);
}

// Staging folders that are not finished. Held while something is given its name.
std::mutex unfinishedMutex;
std::vector<fs::path> unfinished;
std::atomic<bool> published{false};

}  // namespace

void flushFile(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!flushed && error != EINVAL)  // some file systems have nothing to flush
    failOnDisk("{} could not be written completely: {}.", file.filename().string(), systemCause(error));
}

void finishInterrupted(const fs::path& folder) {
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    if (!isOwnName(entry->path())) continue;
    const Folder left(entry->path(), O_NOFOLLOW);
    if (!left.isOurs() || !left.tryLock()) continue;
    std::error_code ignored;
    const bool published = fs::exists(entry->path() / kJournal, ignored);
    if (published && !isOwnJournal(entry->path())) continue;
    try {
      if (published) followJournal(entry->path(), folder);
    } catch (const Error&) {
      continue;  // its files are whole where they are; a later start may have more luck
    }
    fs::remove_all(entry->path(), ignored);
  }
}

Staging::Staging(const fs::path& folder) : folder_(fs::absolute(folder.empty() ? fs::path(".") : folder)) {
  // Inside another staging folder, which its maker has locked, there is nobody else's to look for.
  const Folder outer(folder_);
  if (!isOwnName(folder_) && outer.lock()) finishInterrupted(folder_);
  path_ = folder_ / randomName();
  if (::mkdir(path_.c_str(), 0700) != 0)
    failOnDisk("The folder {} cannot be written: {}.", folder.string(), systemCause(errno));
  Folder inner(path_);
  inner.tryLock();
  lock_ = inner.release();
  const std::lock_guard guard(unfinishedMutex);
  unfinished.push_back(path_);
}

Staging::~Staging() {
  std::error_code ignored;
  if (!fs::exists(path_ / kJournal, ignored)) fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
  const std::lock_guard guard(unfinishedMutex);
  std::erase(unfinished, path_);
}

void Staging::publish(const std::vector<std::string>& obsolete) {
  const std::lock_guard guard(unfinishedMutex);
  std::vector<std::string> lines;
  // All targets are looked at first, so that a refusal leaves an earlier result whole.
  for (const auto& entry : fs::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (!isPlainName(name)) continue;
    if (isTakenByOther(folder_ / name))
      failOnDisk("{} is not an ordinary file and cannot be written; choose another name.",
                 (folder_ / name).string());
    flushFile(entry.path());
    lines.push_back("+" + name);
  }
  for (const std::string& name : obsolete)
    if (isPlainName(name) && std::ranges::count(lines, "+" + name) == 0) lines.push_back("-" + name);
  writeJournal(path_, lines);
  followJournal(path_, folder_);
  published = true;
}

bool hasPublished() { return published; }

void Staging::publishOnly(const std::string& name) {
  const std::lock_guard guard(unfinishedMutex);
  flushFile(path_ / name);
  giveName(path_ / name, folder_ / name);
  Folder(folder_).flush();
}

void removeStaging() {
  const std::lock_guard guard(unfinishedMutex);
  std::error_code ignored;
  for (const fs::path& path : unfinished) fs::remove_all(path, ignored);
  unfinished.clear();
}

}  // namespace sonoskin
