#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// UserPreset: settings that a person keeps under a name: those of how surfaces are found and fitted (enhancement,
// classification, surface, reconstruction, global), as the program's own presets.
struct UserPreset {
  std::string name;
  Parameters parameters;
};

// kMostPresetName: bytes of a name; longer ones are cut.
inline constexpr std::size_t kMostPresetName = 60;

// presetsFile: beside the settings; empty where there is no home.
std::filesystem::path presetsFile();

// readUserPresets: all of a file, by name; what is damaged is left out.
std::vector<UserPreset> readUserPresets(const std::filesystem::path& file);
// writeUserPresets: for this user's eyes alone.
//   errors  Error (system): the file cannot be written
void writeUserPresets(const std::filesystem::path& file, const std::vector<UserPreset>& presets);

// keepPreset: under a name, in the place of one that has it.
void keepPreset(std::vector<UserPreset>& presets, const std::string& name, const Parameters& parameters);

// applyUserPreset: what is a preset's, and leaves the rest.
void applyUserPreset(const UserPreset& preset, Parameters& parameters);
// matchingUserPreset: the one whose settings these are, or null.
const UserPreset* matchingUserPreset(const std::vector<UserPreset>& presets, const Parameters& parameters);

}  // namespace sonoskin
