#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "app/cli/console.h"

namespace sonoskin {

// Command: one word of the command line, and what it does once its options are read and checked.
struct Command {
  CLI::App* app;
  std::function<void()> run;
};

// Each adds its command to the program. The console must outlive the command.
Command addRunCommand(CLI::App& program, Console& console);
Command addRenderCommand(CLI::App& program, Console& console);
Command addSheetCommand(CLI::App& program, Console& console);
Command addPhantomCommand(CLI::App& program, Console& console);
Command addInfoCommand(CLI::App& program, Console& console);
Command addCompareCommand(CLI::App& program, Console& console);
Command addRecipeCommand(CLI::App& program, Console& console);

}  // namespace sonoskin
