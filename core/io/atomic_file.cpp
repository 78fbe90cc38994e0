#include "core/io/atomic_file.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <mutex>

#include "core/base/error.h"
#include "core/base/error_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

template <class... Args>
[[noreturn]] void failOnDisk(fmt::format_string<Args...> sentence, Args&&... args) {
  throw Error(fmt::format(sentence, std::forward<Args>(args)...), Error::Kind::system);
}

// Folders that were made for output that is not finished, in the order in which they were made.
std::mutex madeMutex;
std::vector<fs::path> madeFolders;

// Renaming over a device such as /dev/null would replace it.
void checkTarget(const fs::path& target) {
  std::error_code code;
  const fs::file_status status = fs::status(target, code);
  if (fs::exists(status) && !fs::is_regular_file(status))
    failOnDisk("{} is not an ordinary file and cannot be written; choose another name.", target.string());
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, code))
    failOnDisk("The folder {} does not exist; make it or choose another one.", folder.string());
  if (target.filename().empty())
    failOnDisk("{} names a folder, not a file; add the name of a file.", target.string());
}

// Through a link to the file that it stands for, so that the link stays.
fs::path realTarget(const fs::path& target) {
  std::error_code code;
  if (!fs::is_symlink(fs::symlink_status(target, code))) return target;
  const fs::path real = fs::weakly_canonical(target, code);
  return code ? target : real;
}

}  // namespace

void writeAtomically(const fs::path& target, const std::function<void(const fs::path&)>& write) {
  checkTarget(target);
  const fs::path real = realTarget(target);
  Staging staging(real.parent_path());
  const fs::path temporary = staging.path() / real.filename();
  // Opening it first tells a name or a folder that cannot be used from a writer's own trouble.
  if (!std::ofstream(temporary))
    failOnDisk("{} cannot be written; check the folder's permissions and the free space.", target.string());
  write(temporary);
  staging.publishOnly(real.filename().string());
}

void writeBytes(const fs::path& target, const void* data, std::size_t bytes) {
  writeAtomically(target, [&](const fs::path& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file.write(static_cast<const char*>(data), std::streamsize(bytes));
    file.close();
    std::error_code code;
    if (!file || fs::file_size(temporary, code) != bytes)
      failOnDisk(
          "{} could not be written completely; the disk may be full, make room or choose another place.",
          target.string());
  });
}

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code code;
  std::vector<fs::path> missing;
  for (fs::path p = fs::absolute(folder_); !p.empty() && !fs::exists(p, code); p = p.parent_path())
    missing.insert(missing.begin(), p);
  made_ = missing;
  {
    const std::lock_guard lock(madeMutex);
    madeFolders.insert(madeFolders.end(), made_.begin(), made_.end());
  }
  fs::create_directories(folder_, code);
  if (std::error_code ignored; !fs::is_directory(folder_, ignored)) {
    removeMade();
    failOnDisk("The folder {} cannot be made: {}.", folder_.string(), systemCause(code.value()));
  }
  try {
    staging_.emplace(folder_);
  } catch (...) {
    removeMade();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  staging_.reset();
  removeMade();
}

fs::path OutputFolder::file(const std::string& name) {
  require(!name.empty() && name != "." && name != ".." && fs::path(name).filename() == fs::path(name) &&
              name.find('\n') == std::string::npos,
          "{} is not a plain file name; leave folders and line ends out.", name);
  return staging_->path() / name;
}

void OutputFolder::commit(const std::vector<std::string>& obsolete) {
  staging_->publish(obsolete);
  const std::lock_guard lock(madeMutex);
  for (const fs::path& folder : made_) std::erase(madeFolders, folder);
  made_.clear();
}

// Folders that hold something by now stay.
void OutputFolder::removeMade() {
  const std::lock_guard lock(madeMutex);
  std::error_code ignored;
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) {
    fs::remove(*p, ignored);
    std::erase(madeFolders, *p);
  }
}

void abandonOutput(int exitStatus) {
  removeStaging();
  const std::lock_guard lock(madeMutex);
  std::error_code ignored;
  for (auto path = madeFolders.rbegin(); path != madeFolders.rend(); ++path) fs::remove(*path, ignored);
  ::_exit(exitStatus);
}

}  // namespace sonoskin
