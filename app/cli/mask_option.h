#pragma once

#include <CLI/App.hpp>
#include <string>

namespace sonoskin {

// addMaskOption: --mask FILE, see loadInput.
void addMaskOption(CLI::App& command, std::string& mask);

}  // namespace sonoskin
