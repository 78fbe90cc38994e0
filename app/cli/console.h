#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/cli/progress_line.h"
#include "core/base/log.h"
#include "core/base/progress.h"

namespace sonoskin {

// Console: what all commands share: results go to standard output, as text or as one JSON object; everything
// else goes to standard error, with what is logged while it lives.
class Console {
 public:
  Console();
  ~Console();
  // addJson, addThreads, addNameInput: give a command the options --json, --threads and --name-input.
  void addJson(CLI::App& command);
  void addNameInput(CLI::App& command);
  void addThreads(CLI::App& command);

  ProgressSink& sink() { return line_.sink(); }
  Progress progress() { return Progress(line_.sink()); }
  void beginStage(const std::string& name) { line_.beginStage(name); }

  // nameOf: what a result may say of an input: "phantom"; the name of a file or folder if that was asked for, for it may be
  // a patient's; else nothing.
  std::string nameOf(const std::string& input) const;

  // warn: logs them.
  void warn(const std::vector<std::string>& sentences);
  // warnings: all that were logged since the command began, for its result.
  std::vector<std::string> warnings() const { return record_.sentences(LogLevel::warning); }
  // print: the result of a command, once, at its end.
  void print(const std::string& json, const std::string& text);

 private:
  ProgressLine line_;
  LogRecord record_;
  bool json_ = false, namesInput_ = false;
};

}  // namespace sonoskin
