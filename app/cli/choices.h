#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/fields.h"

namespace sonoskin {

// addChoice: an option whose value is one of the names.
CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& names, const std::string& help);

// addChoices: an option whose value is one or more of the names, with commas between.
CLI::Option* addChoices(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                        const std::vector<std::string>& names, const std::string& help);

// addEnum: an option for an enum by its names, of which the first `skipped` are not offered.
template <NamedEnum E>
void addEnum(CLI::App& command, const std::string& name, E& value, int skipped, const std::string& help) {
  const auto all = enumNames(E{});
  const std::vector<std::string> names(all.begin() + skipped, all.end());
  const auto store = [name, names, skipped, &value](const std::string& text) {
    const auto found = std::ranges::find(names, text);
    if (found == names.end())
      throw Error(fmt::format("{} {} is not known; give one of {}.", name, text, fmt::join(names, ", ")),
                  Error::Kind::usage);
    value = E(skipped + int(found - names.begin()));
  };
  command.add_option_function<std::string>(name, store, help)
      ->type_name(names.size() > 4 ? "NAME" : fmt::format("{}", fmt::join(names, "|")));
}

}  // namespace sonoskin
