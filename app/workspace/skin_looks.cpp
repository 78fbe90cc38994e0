#include "app/workspace/skin_looks.h"

namespace sonoskin {

Look lookOf(const Parameters& parameters) {
  if (const SkinPreset* whole = matchingSkinPreset(parameters.skin, parameters.light)) return {whole, false};
  for (const SkinPreset& preset : skinPresets()) {
    SkinOptions skin;
    LightOptions light;
    applySkinPreset(preset, skin, light);
    if (skin == parameters.skin) return {&preset, true};
  }
  return {};
}

}  // namespace sonoskin
