#include "core/io/atomic_file.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

template <class... Args>
[[noreturn]] void failOnDisk(fmt::format_string<Args...> sentence, Args&&... args) {
  throw Error(fmt::format(sentence, std::forward<Args>(args)...), Error::Kind::system);
}

// A prefix that no other running process or thread uses; the leading dot hides it in listings.
std::string uniquePrefix() {
  static std::atomic<unsigned> counter{0};
  return fmt::format(".sonoskin-{}-{}-", ::getpid(), counter++);
}

// What is not finished: temporary files and folders, and folders that were made for them, in the order in which they
// were made. Held while something is given its name.
std::mutex unfinishedMutex;
std::vector<fs::path> unfinished;

void addUnfinished(const fs::path& path) {
  const std::lock_guard lock(unfinishedMutex);
  unfinished.push_back(fs::absolute(path));
}

void dropUnfinished(const fs::path& path) {
  const std::lock_guard lock(unfinishedMutex);
  std::erase(unfinished, fs::absolute(path));
}

// Removes a file when it goes out of scope; a file that was renamed is no longer there.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) { addUnfinished(path_); }
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
    dropUnfinished(path_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Renaming over a device such as /dev/null would replace it.
void checkTarget(const fs::path& target) {
  std::error_code code;
  const fs::file_status status = fs::status(target, code);
  if (fs::exists(status) && !fs::is_regular_file(status))
    failOnDisk("{} is not an ordinary file and cannot be written; choose another name.", target.string());
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, code))
    failOnDisk("The folder {} does not exist; make it or choose another one.", folder.string());
  if (target.filename().empty()) failOnDisk("{} names a folder, not a file.", target.string());
}

void moveInto(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::rename(from, to, code);
  if (code) failOnDisk("{} could not be written: {}.", to.string(), code.message());
}

}  // namespace

void writeAtomically(const fs::path& target, const std::function<void(const fs::path&)>& write) {
  checkTarget(target);
  const TemporaryFile temporary(target.parent_path() / (uniquePrefix() + target.filename().string()));
  // Opening it first tells a folder without permission from a writer's own trouble.
  if (!std::ofstream(temporary.path()))
    failOnDisk("{} cannot be written; check the folder's permissions and the free space.", target.string());
  write(temporary.path());
  const std::lock_guard lock(unfinishedMutex);
  moveInto(temporary.path(), target);
}

void writeBytes(const fs::path& target, const void* data, std::size_t bytes) {
  writeAtomically(target, [&](const fs::path& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file.write(static_cast<const char*>(data), std::streamsize(bytes));
    file.close();
    if (!file) failOnDisk("{} could not be written completely; is the disk full?", target.string());
  });
}

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code code;
  std::vector<fs::path> missing;
  for (fs::path p = fs::absolute(folder_); !p.empty() && !fs::exists(p, code); p = p.parent_path())
    missing.insert(missing.begin(), p);
  made_ = missing;
  for (const fs::path& folderMade : made_) addUnfinished(folderMade);
  fs::create_directories(folder_, code);
  if (!fs::is_directory(folder_))
    failOnDisk("The folder {} cannot be made: {}.", folder_.string(), code.message());
  staging_ = folder_ / (uniquePrefix() + "unfinished");
  addUnfinished(staging_);
  if (!fs::create_directory(staging_, code))
    failOnDisk("The folder {} cannot be written: {}.", folder_.string(), code.message());
}

OutputFolder::~OutputFolder() {
  removeStaging();
  std::error_code ignored;  // folders that hold something by now stay
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) {
    fs::remove(*p, ignored);
    dropUnfinished(*p);
  }
}

fs::path OutputFolder::file(const std::string& name) {
  require(!name.empty() && name != "." && name != ".." && fs::path(name).filename() == fs::path(name),
          "{} is not a plain file name.", name);
  return staging_ / name;
}

void OutputFolder::commit() {
  {
    const std::lock_guard lock(unfinishedMutex);
    // All targets are looked at first, so that a refusal leaves an earlier result whole.
    for (const auto& entry : fs::directory_iterator(staging_)) checkTarget(folder_ / entry.path().filename());
    for (const auto& entry : fs::directory_iterator(staging_))
      moveInto(entry.path(), folder_ / entry.path().filename());
    for (const fs::path& folder : made_) std::erase(unfinished, folder);
  }
  made_.clear();
  removeStaging();
}

void OutputFolder::removeStaging() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  dropUnfinished(staging_);
}

void abandonOutput(int exitStatus) {
  const std::lock_guard lock(unfinishedMutex);
  std::error_code ignored;
  for (auto path = unfinished.rbegin(); path != unfinished.rend(); ++path) {
    const bool ours = path->filename().string().starts_with(".sonoskin-");
    // A folder that was made for the output may hold something of somebody else's by now: only if empty.
    ours ? fs::remove_all(*path, ignored) : std::uintmax_t(fs::remove(*path, ignored));
  }
  ::_exit(exitStatus);
}

}  // namespace sonoskin
