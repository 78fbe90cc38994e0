#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sonoskin {

// writeAtomically: calls write(temporary) and then gives the file its name, so that the target is either
// complete or as it was before.
//   input   target     an ordinary file or nothing; its folder must exist
//           write      fills the path it is given, which lies in the target's folder and keeps its extension
//   errors  Error (system): the folder is missing or cannot be written, or the target is not an ordinary file;
//           whatever `write` throws. The temporary file is removed then.
void writeAtomically(const std::filesystem::path& target,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

// writeBytes: writes bytes under `target`, atomically.
void writeBytes(const std::filesystem::path& target, const void* data, std::size_t bytes);

// OutputFolder: a set of files that appear in a folder together, when all of them are complete. They are
// written in a hidden folder inside it, so that files that name each other (OBJ and MTL) keep their names.
//   errors  Error (system): the folder cannot be made or written; nothing is left behind then
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path folder);  // made where missing
  ~OutputFolder();                                      // without commit(): removes all that was written
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // file: where to write the file that will be called `name`, a plain file name.
  std::filesystem::path file(const std::string& name);
  // commit: moves every file that was written into the folder, over files of the same name.
  void commit();

 private:
  void removeStaging();

  std::filesystem::path folder_, staging_;
  std::vector<std::filesystem::path> made_;  // folders that did not exist before, outermost first
};

// abandonOutput: removes all that the two above have not finished and ends the program, without destructors; for
// when a person asked to stop and the main thread is in the middle of something that cannot be interrupted.
//   threads  any; a commit under way is completed first
[[noreturn]] void abandonOutput(int exitStatus);

}  // namespace sonoskin
