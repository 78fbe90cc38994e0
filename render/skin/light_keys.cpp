#include "render/skin/light_keys.h"

#include "core/pipeline/parameter_key.h"

namespace sonoskin {
namespace {

Hasher& addVector(Hasher& hasher, const glm::vec3& v) { return hasher.add(v.x).add(v.y).add(v.z); }

}  // namespace

LightKeys lightKeys(std::uint64_t surface, const SkinLook& look, const SkinQuality& quality) {
  // What only the final pass reads, or only the blurs, must not light the skin anew.
  SkinOptions material = look.skin;
  material.detail = 0;
  SkinOptions before = material;
  before.profile = {};
  before.width = before.translucency = 0;
  before.thinModel = {};
  before.gaussians = 1;
  before.absorption = before.scattering = {1, 1, 1};
  LightKeys keys;
  Hasher made("skin material");
  made.add(surface);
  addOptions(made, before);
  addOptions(made, look.landmarks);
  keys.material = made.key();
  Hasher lit("irradiance");
  lit.add(keys.material);
  for (std::size_t i = 0; i < keys.lights.size(); ++i) {
    const SkinLight light = look.lights.light(i);
    Hasher reached("light");
    reached.add(surface).add(quality.shadowSize).add(quality.shadowTaps);
    addVector(reached, light.position).add(light.kind).add(light.shadows).add(light.softness);
    if (light.kind == LightKind::inside) reached.add(look.skin.density);
    keys.lights[i] = reached.key();
    addVector(lit.add(keys.lights[i]), light.colour).add(light.reach);
  }
  for (const glm::vec3& c : look.lights.environment) addVector(lit, c);
  keys.irradiance = lit.key();
  Hasher spread("spread");
  spread.add(keys.irradiance);
  addOptions(spread, material);
  keys.blur = spread.key();
  return keys;
}

}  // namespace sonoskin
