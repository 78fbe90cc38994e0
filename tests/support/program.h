#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace sonoskin::test {

// ProgramResult: how a run of the program ended; status is the exit status, or 128 + signal.
struct ProgramResult {
  int status = -1;
  std::string out, err;
};

// RunningProgram: a program started with arguments, its output kept in files until it ends.
class RunningProgram {
 public:
  RunningProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const std::filesystem::path& folder);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  bool running();
  // catches: whether it has come so far that the signal does not simply end it.
  bool catches(int signal) const;
  void signal(int number);
  ProgramResult wait();

 private:
  void noteEnd(int waitStatus);

  std::filesystem::path out_, err_;
  pid_t child_ = -1;
  int status_ = -1;
};

// filesBelow: the names, relative to the folder, of all files and folders in it, hidden ones too, sorted.
std::vector<std::string> filesBelow(const std::filesystem::path& folder);

}  // namespace sonoskin::test
