#include "tests/support/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "tests/support/temp_folder.h"

namespace sonoskin::test {

RunningProgram::RunningProgram(const std::filesystem::path& program,
                               const std::vector<std::string>& arguments, const std::filesystem::path& folder)
    : out_(folder / ".stdout"), err_(folder / ".stderr") {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  child_ = fork();
  if (child_ < 0) throw std::runtime_error("fork failed");
  if (child_ > 0) return;
  // Between fork and exec only calls that are safe in a signal handler.
  const int out = open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err = open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  execv(argv[0], argv.data());
  _exit(127);
}

RunningProgram::~RunningProgram() {
  if (child_ <= 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

bool RunningProgram::running() {
  int status = 0;
  if (child_ > 0 && waitpid(child_, &status, WNOHANG) == child_) noteEnd(status);
  return child_ > 0;
}

bool RunningProgram::catches(int signal) const {
  const std::string status = fileText("/proc/" + std::to_string(child_) + "/status"), title = "SigCgt:";
  const std::size_t found = status.find(title);
  if (found == std::string::npos) return false;
  return std::stoull(status.substr(found + title.size()), nullptr, 16) >> (signal - 1) & 1;
}

void RunningProgram::signal(int number) {
  if (child_ > 0) kill(child_, number);
}

ProgramResult RunningProgram::wait() {
  int status = 0;
  if (child_ > 0 && waitpid(child_, &status, 0) == child_) noteEnd(status);
  ProgramResult result{status_, fileText(out_), fileText(err_)};
  std::filesystem::remove(out_);
  std::filesystem::remove(err_);
  return result;
}

void RunningProgram::noteEnd(int waitStatus) {
  child_ = -1;
  status_ = WIFEXITED(waitStatus) ? WEXITSTATUS(waitStatus) : 128 + WTERMSIG(waitStatus);
}

std::vector<std::string> filesBelow(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    names.push_back(entry.path().lexically_relative(folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace sonoskin::test
