#pragma once

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

}  // namespace sonoskin::accuracy
