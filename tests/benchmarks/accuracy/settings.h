#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/parameters.h"

namespace sonoskin::accuracy {

// Setting: "group.field=value" as it was given.
struct Setting {
  std::string name, value;
};

// parseSettings: "surface.facing=0.1,0.2" gives one setting per value, separated by commas.
//   errors   Error: no "="
std::vector<Setting> parseSettings(const std::string& text);

// apply: sets one parameter of the recipe.
//   errors   Error: no such parameter, or a value it cannot take
void apply(const Setting& setting, Parameters& parameters);

// Given: what the command line says of the parameters.
//   sets   "group.field=value" each
//   dims   of the simulated scan, three or none
//   seed   of its speckle
struct Given {
  std::vector<std::string> sets;
  std::vector<int> dims;
  std::optional<int> seed;

  // names: whether one of the sets is of this parameter.
  bool names(const std::string& parameter) const;
};

// parametersOf: the defaults with `sets`, and then with dims and seed where they are given.
//   errors   Error: as parseSettings and apply
Parameters parametersOf(const Given& given);

}  // namespace sonoskin::accuracy
