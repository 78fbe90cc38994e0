#pragma once

#include "core/pipeline/parameters.h"
#include "core/skin/skin_presets.h"

namespace sonoskin {

// Look: the named look that parameters are: the skin's, with the light as it comes with it or another one; nullptr: none.
struct Look {
  const SkinPreset* preset = nullptr;
  bool otherLight = false;
};
Look lookOf(const Parameters& parameters);

}  // namespace sonoskin
