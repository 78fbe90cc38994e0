#pragma once

#include <CLI/App.hpp>

#include "app/document/input.h"

namespace sonoskin {

// addMaskOptions: --mask FILE and --erase FILE.
void addMaskOptions(CLI::App& command, InputFiles& files);

}  // namespace sonoskin
