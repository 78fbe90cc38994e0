#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sonoskin {

// Staging: a hidden folder inside another one, in which output is made before it gets its name. Only this user may enter
// it, its name is random, and a lock says that its maker lives; so no other program, machine or planted link meets it.
// What an ended program left in the same folder is taken up first, see finishInterrupted.
//   errors  Error (system): the folder cannot be written
class Staging {
 public:
  explicit Staging(const std::filesystem::path& folder);
  ~Staging();  // removes it with all that it holds
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  const std::filesystem::path& path() const { return path_; }

  // publish: gives every file in it its name in the folder, and takes `obsolete` away: all of it, or after a crash
  // either none or, as soon as anything is written there again, all. Files keep the permissions of those they replace.
  //   obsolete  plain names without line ends, as those of the files; what does not exist or is no ordinary file is left
  //             alone
  //   errors    Error (system): a name is taken by something that is no ordinary file, or the disk is full: nothing was
  //             changed then; or the system refuses a name: then the next output there goes on
  void publish(const std::vector<std::string>& obsolete = {});
  // publishOnly: the same for one file, whose name may hold anything.
  //   errors    as publish
  void publishOnly(const std::string& name);

 private:
  std::filesystem::path folder_, path_;
  int lock_ = -1;
};

// finishInterrupted: what programs that ended in the middle of their output left in a folder: sets that were being
// published are completed, all else is removed. Leaves alone what belongs to somebody else or is in use.
void finishInterrupted(const std::filesystem::path& folder);

// hasPublished: whether a set of files was published since the program began.
bool hasPublished();

// flushFile: waits until a file is on the disk.
//   errors  Error (system): it could not be written completely
void flushFile(const std::filesystem::path& file);

// removeStaging: removes every staging folder of this program, for when it ends without destructors.
//   threads  any; a set that is being published is completed first
void removeStaging();

}  // namespace sonoskin
