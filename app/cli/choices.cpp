#include "app/cli/choices.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"

namespace sonoskin {
CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& names, const std::string& help) {
  const std::string text = value.empty() ? help : fmt::format("{} [default {}]", help, value);
  return command.add_option(name, value, text)
      ->type_name(fmt::format("{}", fmt::join(names, "|")))
      ->check(CLI::IsMember(names).description(""));  // the type tells the names already
}

CLI::Option* addChoices(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                        const std::vector<std::string>& names, const std::string& help) {
  const auto store = [name, names, &values](const std::string& text) {
    values = CLI::detail::split(text, ',');
    for (const std::string& value : values) {
      if (std::ranges::count(names, value) == 0)
        throw Error(fmt::format("{} {} is not known; give one or more of {}, with commas.", name, text,
                                fmt::join(names, ", ")),
                    Error::Kind::usage);
    }
  };
  const std::string text =
      values.empty() ? help : fmt::format("{} [default {}]", help, fmt::join(values, ","));
  return command.add_option_function<std::string>(name, store, text)
      ->type_name(fmt::format("{}", fmt::join(names, ",")));
}

}  // namespace sonoskin
