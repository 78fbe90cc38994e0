#include "tests/benchmarks/accuracy/settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/pipeline/recipe.h"

namespace sonoskin::accuracy {

std::vector<Setting> parseSettings(const std::string& text) {
  const std::size_t equals = text.find('=');
  require(equals != std::string::npos, "{}: write group.field=value", text);
  std::vector<Setting> settings;
  for (std::size_t from = equals + 1; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    settings.push_back({text.substr(0, equals), text.substr(from, comma - from)});
    from = comma + 1;
  }
  return settings;
}

void apply(const Setting& setting, Parameters& parameters) {
  const std::size_t dot = setting.name.find('.');
  require(dot != std::string::npos, "{}: write group.field=value", setting.name);
  nlohmann::json value = nlohmann::json::parse(setting.value, nullptr, false);
  if (value.is_discarded()) value = setting.value;  // the name of a choice
  const nlohmann::json recipe{{setting.name.substr(0, dot), {{setting.name.substr(dot + 1), value}}}};
  readRecipe(recipe.dump(), parameters);
}

bool Given::names(const std::string& parameter) const {
  return std::any_of(sets.begin(), sets.end(),
                     [&](const std::string& text) { return text.starts_with(parameter + "="); });
}

Parameters parametersOf(const Given& given) {
  Parameters parameters;
  for (const std::string& text : given.sets)
    for (const Setting& setting : parseSettings(text)) apply(setting, parameters);
  if (given.dims.size() == 3) parameters.phantom.dims = {given.dims[0], given.dims[1], given.dims[2]};
  if (given.seed) parameters.phantom.seed = *given.seed;
  return parameters;
}

}  // namespace sonoskin::accuracy
