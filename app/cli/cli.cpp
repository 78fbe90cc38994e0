#include "app/cli/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/exit_status.h"
#include "app/cli/interrupt.h"
#include "app/cli/parameter_options.h"
#include "app/cli/streams.h"
#include "app/window/window.h"
#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/parallel.h"
#include "core/base/version.h"
#include "core/io/file_formats.h"
#include "core/io/reader_process.h"

namespace sonoskin {
namespace {

// fail: the one line on standard error that says what went wrong.
int fail(ExitStatus status, std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  message = asSentence(message);
  std::fputs(fmt::format("sonoskin: error: {}\n", message).c_str(), stderr);
  return status;
}

ExitStatus statusOf(Error::Kind kind) {
  switch (kind) {
    case Error::Kind::input:
      return kInput;
    case Error::Kind::usage:
      return kUsage;
    case Error::Kind::system:
      break;
  }
  return kOther;
}

// The words of the parser of options, with what to do.
std::string usageSentence(std::string words) {
  while (!words.empty() && (words.back() == '\n' || words.back() == '.')) words.pop_back();
  return words + "; see --help.";
}

// Software OpenGL takes a thread for every processor of the machine, whatever we may use of them. What users set for
// themselves stays. Here, since no other thread is there yet that could read what is set.
void limitRenderer() { ::setenv("LP_NUM_THREADS", std::to_string(threadCount()).c_str(), 0); }

int runWindow(const std::string& file, const Parameters& parameters) {
  if (file.empty()) return openWindow(std::nullopt, parameters);
  if (std::error_code ignored; !std::filesystem::exists(file, ignored)) {
    return fail(kUsage,
                fmt::format("There is no command and no file named \"{}\"; see sonoskin --help.", file));
  }
  return openWindow(file, parameters);
}

int parseAndRun(int argc, char** argv) {
  CLI::App program(
      "Sonoskin makes a smooth surface and a picture of a face from noisy 3D ultrasound.\n"
      "For research and keepsakes, not for diagnosis.\n"
      "Without a command the window opens, on FILE or on a simulated scan.",
      "sonoskin");
  program.set_version_flag("--version", std::string("sonoskin ") + kVersion);
  program.get_formatter()->column_width(46);
  program.footer(
      fmt::format("Volumes: {}.\nMeshes: {}.\n"
                  "Exit status: 0 done, 2 wrong usage, 3 bad input, 4 cancelled, 1 anything else.",
                  formatList(FileKind::readVolume), formatList(FileKind::readMesh)));

  std::string file;
  ParameterOptions parameters;
  program.add_option("FILE", file, "volume or session to open in the window")->type_name("");
  parameters.addPreset(program);
  parameters.addRecipe(program);
  parameters.addLook(program);

  Console console;
  console.addThreads(program);
  const std::vector<Command> commands = {
      addRunCommand(program, console),   addRenderCommand(program, console),
      addSheetCommand(program, console), addPhantomCommand(program, console),
      addInfoCommand(program, console),  addCompareCommand(program, console),
      addRecipeCommand(program, console)};
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return fail(kUsage, usageSentence(error.what()));
    std::ostringstream text;  // the help or the version
    program.exit(error, text, text);
    writeResult(text.str());
    return kDone;
  }
  limitRenderer();
  for (const Command& command : commands) {
    if (!command.app->parsed()) continue;
    const Interrupt interrupt(console.sink());
    command.run();
    return kDone;
  }
  return runWindow(file, parameters.resolve());
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  prepareStreams();
  startReaders();
  try {
    return parseAndRun(argc, argv);
  } catch (const Cancelled&) {
    return fail(kCancelled, cancelledSentence());
  } catch (const BrokenPipe&) {
    return kOther;
  } catch (const Error& error) {
    return fail(statusOf(error.kind()), error.what());
  } catch (const std::exception& error) {
    return fail(kOther, errorText(error));
  }
}

}  // namespace sonoskin
