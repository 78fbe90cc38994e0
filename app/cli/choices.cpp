#include "app/cli/choices.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sonoskin {
namespace {

// The names are in the option's type already; CLI11 would print them again after it.
CLI::Validator isOneOf(const std::vector<std::string>& names) { return CLI::IsMember(names).description(""); }

}  // namespace

CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& names, const std::string& help) {
  const std::string text = value.empty() ? help : fmt::format("{} [default {}]", help, value);
  return command.add_option(name, value, text)
      ->type_name(fmt::format("{}", fmt::join(names, "|")))
      ->check(isOneOf(names));
}

CLI::Option* addChoices(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                        const std::vector<std::string>& names, const std::string& help) {
  const std::string text =
      values.empty() ? help : fmt::format("{} [default {}]", help, fmt::join(values, ","));
  return command.add_option(name, values, text)
      ->delimiter(',')
      ->expected(1)
      ->type_name(fmt::format("{}", fmt::join(names, ",")))
      ->check(isOneOf(names));
}

}  // namespace sonoskin
