#pragma once

#include <CLI/App.hpp>

#include "app/input.h"

namespace sonoskin {

// addMaskOptions: --mask FILE and --erase FILE.
void addMaskOptions(CLI::App& command, InputFiles& files);

}  // namespace sonoskin
