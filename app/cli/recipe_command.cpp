#include <fmt/format.h>

#include <memory>

#include "app/cli/commands.h"
#include "app/cli/parameter_options.h"
#include "app/document/parameter_text.h"
#include "core/pipeline/recipe.h"

namespace sonoskin {
namespace {

struct RecipeOptions {
  ParameterOptions parameters;
  bool explain = false;
};

// explanation: a Markdown table for each group, as it stands in assets/docs/parameters.md.
std::string explanation(const Parameters& parameters) {
  std::string text, group;
  for (const ParameterInfo& p : describeParameters(parameters)) {
    if (p.group != group) {
      text += fmt::format(
          "{}**{}**\n\n| parameter | symbol | value | range | unit | meaning |\n"
          "|---|---|---|---|---|---|\n",
          group.empty() ? "" : "\n", p.group);
      group = p.group;
    }
    std::string range = p.range.empty() ? p.kind : p.range;
    for (std::size_t at = 0; (at = range.find('|', at)) != std::string::npos;) range.replace(at, 1, ", ");
    text +=
        fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", p.name, p.symbol, p.value, range, p.unit, p.help);
  }
  return text;
}

}  // namespace

Command addRecipeCommand(CLI::App& program, Console& console) {
  auto options = std::make_shared<RecipeOptions>();
  CLI::App* command = program.add_subcommand("recipe", "print the parameters of a run as JSON, for --recipe");
  options->parameters.addTo(*command);
  command->add_flag("--explain", options->explain,
                    "a table of every field instead: symbol, value, range, meaning");
  console.addJson(*command);
  return {command, [options, &console] {
            const Parameters parameters = options->parameters.resolve();
            const std::string json = writeRecipe(parameters);
            console.print(json, options->explain ? explanation(parameters) : json);
          }};
}

}  // namespace sonoskin
