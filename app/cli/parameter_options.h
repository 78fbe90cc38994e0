#pragma once

#include <CLI/App.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/document/input.h"

namespace sonoskin {

// ParameterOptions: --preset, --recipe, --look and one option --group.field for every parameter, on a command. They are
// checked while the command line is read; resolve() then applies the preset first, the recipe on top of it, then the
// look of the skin, and the single options on top of that. Must outlive the parsing.
class ParameterOptions {
 public:
  void addTo(CLI::App& command);
  // addPreset, addRecipe, addLook: --preset alone, --recipe alone, --look alone.
  void addPreset(CLI::App& command);
  void addRecipe(CLI::App& command);
  void addLook(CLI::App& command);
  // addOne: one parameter alone, under a short name too.
  void addOne(CLI::App& command, const std::string& shortName, const std::string& name);

  // resolve: the defaults, changed by the preset, changed by the recipe, changed by the look, changed by the options.
  //   files   their recipe and measures become what the recipe or session says of its input, if there is one
  //   errors  Error: the recipe cannot be read, or is not one
  Parameters resolve() const;
  Parameters resolve(InputFiles& files) const;

  // recipeFile: of --recipe; empty: none.
  const std::string& recipeFile() const { return recipe_; }

 private:
  std::string preset_;
  std::string recipe_, look_;
  std::vector<std::pair<std::string, std::string>> given_;  // name and text, in the order of the command line
};

}  // namespace sonoskin
