#include "render/skin/entering_light.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include "render/skin/blur_levels.h"
#include "render/skin/gpu_skin.h"

namespace sonoskin {
namespace {

glm::vec3 vec(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

void setLandmarks(gl::Program& program, const LandmarkOptions& l) {
  program.set("rightEye", vec(l.rightEye));
  program.set("leftEye", vec(l.leftEye));
  program.set("noseTip", vec(l.noseTip));
  program.set("mouthRight", vec(l.mouthRight));
  program.set("mouthLeft", vec(l.mouthLeft));
  program.set("eyesSet", isSet(l.rightEye) && isSet(l.leftEye) ? 1.f : 0.f);
  program.set("noseSet", isSet(l.noseTip) ? 1.f : 0.f);
  program.set("mouthSet", isSet(l.mouthRight) && isSet(l.mouthLeft) ? 1.f : 0.f);
}

// The surface's own maps, at texture units 0 to 2.
void bindSurface(gl::Program& program, const GpuSkin& surface) {
  bindTo(program, "positionMap", 0, surface.parts().position);
  bindTo(program, "normalMap", 1, surface.parts().normal);
  bindTo(program, "openMap", 2, surface.parts().open);
}

}  // namespace

SkinTables::SkinTables(const SkinMaterial& m) {
  std::vector<glm::vec4> albedo;
  for (const glm::vec3& c : m.pigments.albedo) albedo.emplace_back(c, 1);
  pigments = gl::Texture({.size = {PigmentTable::kMelanin, PigmentTable::kBlood, PigmentTable::kOxygen},
                          .format = gl::Format::rgba16f});
  pigments.upload(albedo.data());
  std::vector<glm::vec4> through;
  for (const glm::vec3& t : m.transmittance) through.emplace_back(t, 1);
  transmittance = gl::Texture({.size = {SkinMaterial::kSteps, 1, 0}, .format = gl::Format::rgba16f});
  transmittance.upload(through.data());
}

EnteringLight::EnteringLight()
    : specularTable_(specularTexture()),
      material_(emptyMap({gl::Format::rgba16f, gl::Format::rgba8})),
      visibility_(emptyMap({gl::Format::rgba16f, gl::Format::rgba16f})),
      irradiance_(emptyMap({gl::Format::rgba16f})) {}

void EnteringLight::fit(const GpuSkin& surface) {
  for (gl::Framebuffer* map : {&material_, &visibility_, &irradiance_}) {
    map->fit(surface.parts().atlasSize());
    map->clear({});
  }
}

void EnteringLight::adopt(const SkinLook& look, const SkinQuality& quality) {
  if (!tables_.pigments || !(look.skin == look_.skin)) {
    skin_ = makeSkinMaterial(look.skin);
    tables_ = SkinTables(skin_);
  }
  look_ = look;
  quality_ = quality;
}

void EnteringLight::drawMaterial(const GpuSkin& surface) {
  const SkinOptions& o = look_.skin;
  gl::Program& p = programs_.use("skin/material.frag", {});
  bindSurface(p, surface);
  bindTo(p, "pigments", 3, tables_.pigments);
  p.set("melaninRange", glm::vec2(PigmentTable::kLeastMelanin, PigmentTable::kMostMelanin));
  p.set("bloodRange", glm::vec2(PigmentTable::kLeastBlood, PigmentTable::kMostBlood));
  const std::pair<const char*, double> numbers[] = {
      {"melanin", o.melanin}, {"blood", o.blood},       {"oxygen", o.oxygen},
      {"flush", o.flush},     {"mottling", o.mottling}, {"vernix", o.vernix},
      {"wetness", o.wetness}, {"gloss", o.gloss},       {"roughness", o.roughness}};
  for (const auto& [name, value] : numbers) p.set(name, float(value));
  p.set("vernixAlbedo", skin_.vernix);
  p.set("painted", o.colour == SkinColour::pigments ? 1.f : 0.f);
  setLandmarks(p, look_.landmarks);
  material_.bind();
  surface.parts().drawAtlas();
}

void EnteringLight::drawLightMap(const GpuSkin& surface, std::size_t light) {
  lightMaps_.draw(surface, look_.lights, light, quality_.shadowSize);
}

void EnteringLight::drawVisibility(const GpuSkin& surface, std::size_t light) {
  gl::Program& p =
      programs_.use("skin/visibility.frag", {kindDefine(look_.lights), fmt::format("LIGHT {}", light),
                                             fmt::format("TAPS {}", quality_.shadowTaps)});
  bindSurface(p, surface);
  bindTo(p, "depthMap", 3, lightMaps_.depth(light));
  bindTo(p, "placeMap", 4, lightMaps_.place());
  bindTo(p, "exitMap", 5, lightMaps_.exit(light));
  lightMaps_.setLights(p, look_.lights);
  p.set("density", float(look_.skin.density));
  visibility_.bind();
  glColorMask(light == 0, light == 1, light == 2, GL_TRUE);
  surface.parts().drawAtlas();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void EnteringLight::drawIrradiance(const GpuSkin& surface) {
  gl::Program& p = programs_.use("skin/irradiance.frag", {kindDefine(look_.lights)});
  bindSurface(p, surface);
  bindTo(p, "albedoMap", 3, albedo());
  bindTo(p, "finishMap", 4, finish());
  bindTo(p, "specularTable", 5, specularTable_);
  bindTo(p, "visibilityMap", 6, visibility());
  lightMaps_.setLights(p, look_.lights);
  p.set("mixBefore", float(look_.skin.mix));
  irradiance_.bind();
  surface.parts().drawAtlas();
}

void EnteringLight::giveBackMaps() {
  if (look_.skin.thinModel == ThinModel::slab) lightMaps_.giveBack();
}

void EnteringLight::giveBackLight() {
  lightMaps_.giveBack();
  irradiance_.fit({1, 1});
}

void EnteringLight::set(const std::vector<glm::vec4>& irradiance) {
  material_.clear(glm::vec4(1));
  irradiance_.clear({});
  irradiance_.setTexels(0, irradiance.data());
}

std::size_t EnteringLight::bytes() const {
  return material_.texels() * 12 + visibility_.texels() * 16 + irradiance_.texels() * 8 + lightMaps_.bytes();
}

}  // namespace sonoskin
