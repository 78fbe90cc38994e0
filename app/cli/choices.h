#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace sonoskin {

// addChoice: an option whose value is one of the names.
CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& names, const std::string& help);

// addChoices: an option whose value is one or more of the names, with commas between.
CLI::Option* addChoices(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                        const std::vector<std::string>& names, const std::string& help);

}  // namespace sonoskin
