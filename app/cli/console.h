#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/cli/progress_line.h"
#include "core/base/progress.h"

namespace sonoskin {

// Console: what all commands share: results go to standard output, as text or as one JSON object; everything
// else goes to standard error.
class Console {
 public:
  // addJson, addThreads: give a command the options --json and --threads.
  void addJson(CLI::App& command);
  void addThreads(CLI::App& command);

  ProgressSink& sink() { return line_.sink(); }
  Progress progress() { return Progress(line_.sink()); }
  void beginStage(const std::string& name) { line_.beginStage(name); }

  // warn: a line each, above the result.
  void warn(const std::vector<std::string>& sentences);
  // print: the result of a command, once, at its end.
  void print(const std::string& json, const std::string& text);

 private:
  ProgressLine line_;
  bool json_ = false;
};

}  // namespace sonoskin
