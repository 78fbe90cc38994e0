#include "app/workspace/user_presets.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/workspace/settings.h"
#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/private_file.h"
#include "core/pipeline/parameter_key.h"
#include "core/pipeline/recipe.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 5> kGroups{"enhancement", "classification", "surface", "reconstruction",
                                             "global"};

Key keyOf(const Parameters& p) {
  Hasher hasher("preset");
  addOptions(hasher, p.enhancement);
  addOptions(hasher, p.classification);
  addOptions(hasher, p.surface);
  addOptions(hasher, p.reconstruction);
  addOptions(hasher, p.global);
  return hasher.key();
}

Json toJson(const Parameters& parameters) {
  const Json all = Json::parse(writeRecipe(parameters));
  Json own;
  for (const char* group : kGroups) own[group] = all[group];
  return own;
}

bool byName(const UserPreset& a, const UserPreset& b) { return a.name < b.name; }

}  // namespace

fs::path presetsFile() {
  const fs::path settings = settingsFile();
  return settings.empty() ? settings : settings.parent_path() / "presets.json";
}

std::vector<UserPreset> readUserPresets(const fs::path& file) {
  std::vector<UserPreset> presets;
  try {
    const Json root = Json::parse(readText(file), nullptr, false);
    if (!root.is_object()) return presets;
    for (const auto& [name, recipe] : root.items()) {
      UserPreset preset{name.substr(0, kMostPresetName), {}};
      try {
        readRecipe(recipe.dump(), preset.parameters);
        presets.push_back(preset);
      } catch (const Error&) {  // of a newer version, or damaged
      }
    }
  } catch (const Error&) {  // there is none
  }
  std::ranges::sort(presets, byName);
  return presets;
}

void writeUserPresets(const fs::path& file, const std::vector<UserPreset>& presets) {
  require(!file.empty(), "Presets are kept in the home folder, and there is none; set HOME.");
  Json root = Json::object();
  for (const UserPreset& preset : presets) root[preset.name] = toJson(preset.parameters);
  writePrivately(file, root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void keepPreset(std::vector<UserPreset>& presets, const std::string& name, const Parameters& parameters) {
  const UserPreset kept{name.substr(0, kMostPresetName), parameters};
  std::erase_if(presets, [&](const UserPreset& p) { return p.name == kept.name; });
  presets.push_back(kept);
  std::ranges::sort(presets, byName);
}

void applyUserPreset(const UserPreset& preset, Parameters& parameters) {
  parameters.enhancement = preset.parameters.enhancement;
  parameters.classification = preset.parameters.classification;
  parameters.surface = preset.parameters.surface;
  parameters.reconstruction = preset.parameters.reconstruction;
  parameters.global = preset.parameters.global;
}

const UserPreset* matchingUserPreset(const std::vector<UserPreset>& presets, const Parameters& parameters) {
  const Key key = keyOf(parameters);
  const auto found =
      std::ranges::find_if(presets, [&](const UserPreset& p) { return keyOf(p.parameters) == key; });
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace sonoskin
