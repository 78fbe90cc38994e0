#pragma once

#include "core/base/hash.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// LightKeys: fingerprints of what each of the light passes depends on; `irradiance` holds those before it, `blur` all.
//   lights   per light: of its depth map and of what it reaches
struct LightKeys {
  Key material;
  std::array<Key, LightRig::kMost> lights;
  Key irradiance, blur;
  friend bool operator==(const LightKeys&, const LightKeys&) = default;
};

// lightKeys: of a look on the surface of that number (GpuSkin::Parts). The camera is no part of it, nor is what only the
// final pass reads, nor the way in which light spreads.
LightKeys lightKeys(std::uint64_t surface, const SkinLook& look, const SkinQuality& quality);

}  // namespace sonoskin
