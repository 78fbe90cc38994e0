#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/io/staging.h"

namespace sonoskin {

// writeAtomically: calls write(temporary), waits until the file is on the disk, and gives it its name, so that the
// target is either complete or as it was before. It keeps its permissions; where it is a link, the link stays.
//   input   target     an ordinary file, a link to one, or nothing; its folder must exist
//           write      fills the path it is given, which has the target's name; it looks itself whether all was written
//   errors  Error (system): the folder is missing or cannot be written, or the target is not an ordinary file;
//           whatever `write` throws. The temporary file is removed then.
void writeAtomically(const std::filesystem::path& target,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

// writeBytes: writes bytes under `target`, atomically.
//   errors  Error (system): the file cannot be written
void writeBytes(const std::filesystem::path& target, const void* data, std::size_t bytes);

// OutputFolder: a set of files that appear in a folder together, when all of them are complete (Staging::publish). They
// are written in a hidden folder inside it, so that files that name each other (OBJ and MTL) keep their names.
//   errors  Error (system): the folder cannot be made or written; nothing is left behind then
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path folder);  // made where missing
  ~OutputFolder();                                      // removes all that was not committed
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // file: where to write the file that will be called `name`, a plain file name.
  //   errors  Error: it is no plain file name
  std::filesystem::path file(const std::string& name);
  // commit: moves every file that was written into the folder, over files of the same name, and removes those that are
  // obsolete. More may be written and committed after it.
  //   errors  as Staging::publish
  void commit(const std::vector<std::string>& obsolete = {});

 private:
  void removeMade();

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  // folders that did not exist before, outermost first
  std::optional<Staging> staging_;
};

// abandonOutput: removes all that the two above have not finished and ends the program, without destructors; for
// when a person asked to stop and the main thread is in the middle of something that cannot be interrupted.
//   threads  any; a commit under way is completed first
[[noreturn]] void abandonOutput(int exitStatus);

}  // namespace sonoskin
