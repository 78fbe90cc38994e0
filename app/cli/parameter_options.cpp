#include "app/cli/parameter_options.h"

#include <fmt/format.h>

#include <CLI/Error.hpp>

#include "app/document/measure_file.h"
#include "app/document/parameter_text.h"
#include "app/document/session_file.h"
#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/pipeline/presets.h"
#include "core/skin/skin_presets.h"

namespace sonoskin {
namespace {

// "weight of the iso-value term [0.01 .. 4, default 1] (alpha)"
std::string helpLine(const ParameterInfo& p) {
  std::string facts = p.range;
  if (!p.unit.empty()) facts += (facts.empty() ? "" : " ") + p.unit;
  facts += (facts.empty() ? "default " : ", default ") + p.value;
  return fmt::format("{} [{}]{}", p.help, facts, p.symbol.empty() ? "" : " (" + p.symbol + ")");
}

// readRecipeFile: sets what a recipe or a session says; its errors name the file.
void readRecipeFile(const std::string& file, Parameters& parameters, InputFiles& files) {
  const std::string text = readText(file, kMostSessionBytes);
  try {
    files.recipe = readRecipe(recipeIn(text), parameters);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", file, error.what()), error.kind());
  }
  files.measures = measuresIn(text);
}

}  // namespace

void ParameterOptions::addPreset(CLI::App& command) {
  std::string help = "settings that belong together; --recipe and single options go on top of them";
  for (const Preset& preset : presets()) help += fmt::format("\n{}: {}", preset.name, preset.help);
  const auto store = [this](const std::string& name) { preset_ = findPreset(name).name; };
  command.add_option_function<std::string>("--preset", store, help)->type_name("NAME");
}

void ParameterOptions::addRecipe(CLI::App& command) {
  command
      .add_option(
          "--recipe", recipe_,
          "JSON file of parameters, or a session, whose measures a report has, too; single options go on top "
          "of it")
      ->type_name("FILE");
}

void ParameterOptions::addLook(CLI::App& command) {
  std::string help =
      "skin and light that belong together; goes on top of a recipe, single options on top of it";
  for (const SkinPreset& look : skinPresets()) help += fmt::format("\n{}: {}", look.name, look.help);
  const auto store = [this](const std::string& name) { look_ = findSkinPreset(name).name; };
  command.add_option_function<std::string>("--look", store, help)->type_name("NAME");
}

void ParameterOptions::addTo(CLI::App& command) {
  addPreset(command);
  addRecipe(command);
  addLook(command);
  for (const ParameterInfo& parameter : describeParameters({}))
    addOne(command, parameter.name == "scan.volume" ? "volume" : "", parameter.name);
}

void ParameterOptions::addOne(CLI::App& command, const std::string& shortName, const std::string& name) {
  for (const ParameterInfo& parameter : describeParameters({})) {
    if (parameter.name != name) continue;
    const std::string names = (shortName.empty() ? "" : "--" + shortName + ",") + "--" + name;
    auto store = [this, name](const std::string& text) {
      Parameters scratch;
      setParameter(scratch, name, text);  // refuses bad text before any work
      given_.emplace_back(name, text);
    };
    command.add_option_function<std::string>(names, store, helpLine(parameter))
        ->type_name(parameter.kind)
        ->group(parameter.group);
  }
}

Parameters ParameterOptions::resolve() const {
  InputFiles unused;
  return resolve(unused);
}

Parameters ParameterOptions::resolve(InputFiles& files) const {
  Parameters parameters;
  if (!preset_.empty()) applyPreset(findPreset(preset_), parameters);
  if (!recipe_.empty()) readRecipeFile(recipe_, parameters, files);
  if (!look_.empty()) applySkinPreset(findSkinPreset(look_), parameters.skin, parameters.light);
  for (const auto& [name, text] : given_) setParameter(parameters, name, text);
  return parameters;
}

}  // namespace sonoskin
