#pragma once

#include <span>
#include <string_view>

#include "core/pipeline/parameters.h"

namespace sonoskin {

// Preset: settings that belong together, under a name.
//   help    one sentence for people, no full stop
//   change  what it changes of the defaults
struct Preset {
  std::string_view name;
  std::string_view help;
  void (*change)(Parameters&);
};

// presets: all of them, "default" first.
std::span<const Preset> presets();

// findPreset: the preset of that name.
//   errors   Error (usage): there is none; the sentence lists all
const Preset& findPreset(std::string_view name);

// applyPreset: brings the groups classification, surface and reconstruction to their defaults and then to the
// preset's values. What belongs to the scan or to the choice of a piece (phantom, scan, mesh) stays as it is.
void applyPreset(const Preset& preset, Parameters& parameters);

// matchingPreset: the preset whose values these are, or nullptr.
const Preset* matchingPreset(const Parameters& parameters);

}  // namespace sonoskin
