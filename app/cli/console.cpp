#include "app/cli/console.h"

#include "app/cli/streams.h"
#include "app/document/input.h"
#include "core/base/error_text.h"
#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kMostThreads = 1024;

}  // namespace

Console::Console() {
  setLogListener(
      [this](LogLevel level, const std::string& sentence) { line_.say(logLine(level, sentence)); });
}

Console::~Console() { setLogListener({}); }

void Console::addJson(CLI::App& command) {
  command.add_flag("--json", json_, "the result as one JSON object on standard output");
}

void Console::addNameInput(CLI::App& command) {
  command.add_flag("--name-input", namesInput_,
                   "the input's file name in results; without it they hold fingerprints alone");
}

std::string Console::nameOf(const std::string& input) const {
  return namesInput_ || input == kPhantomInput ? inputName(input) : std::string();
}

void Console::addThreads(CLI::App& command) {
  command
      .add_option_function<int>(
          "--threads", setThreadCount,
          "threads to use, for drawing too; by default as many as the system lets the program have")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads).description(""));
}

void Console::warn(const std::vector<std::string>& sentences) {
  line_.finish();
  for (const std::string& sentence : sentences) log(LogLevel::warning, asSentence(sentence));
}

void Console::print(const std::string& json, const std::string& text) {
  line_.finish();
  const std::string& result = json_ ? json : text;
  writeResult(result.ends_with('\n') ? result : result + '\n');
}

}  // namespace sonoskin
