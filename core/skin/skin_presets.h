#pragma once

#include <span>
#include <string_view>

#include "core/skin/light_options.h"
#include "core/skin/skin_options.h"

namespace sonoskin {

// SkinPreset: a look: skin and the light on it, under a name.
//   help     one sentence for people, no full stop
//   change   what it changes of the defaults
struct SkinPreset {
  std::string_view name;
  std::string_view help;
  void (*change)(SkinOptions&, LightOptions&);
};

// skinPresets: all of them, "newborn" first: the defaults.
std::span<const SkinPreset> skinPresets();

// findSkinPreset: the look of that name.
//   errors   Error (usage): there is none; the sentence lists all
const SkinPreset& findSkinPreset(std::string_view name);

// applySkinPreset: brings skin and light to their defaults and then to the look's values.
void applySkinPreset(const SkinPreset& preset, SkinOptions& skin, LightOptions& light);

// matchingSkinPreset: the look whose values these are, or nullptr.
const SkinPreset* matchingSkinPreset(const SkinOptions& skin, const LightOptions& light);

}  // namespace sonoskin
