#include "render/skin/light_passes.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <cmath>

#include "render/gl/read_pixels.h"
#include "render/skin/gpu_skin.h"

namespace sonoskin {
namespace {

constexpr double kThinSmoothing = 0.75;  // mm: what comes through a plate is spread by it
constexpr double kThinLooks = 0.25;      // mm^2: what the looks for a depth spread over, a disc of 1 mm

glm::vec3 vec(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

// Whether light is to spread from point to point.
bool wantsPoints(const GpuSkin& surface, const SkinQuality& quality) {
  return surface.surface()->pointBased || quality.points;
}

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

LightPasses::LightPasses()
    : material_(emptyMap({gl::Format::rgba16f, gl::Format::rgba8})),
      visibility_(emptyMap({gl::Format::rgba16f, gl::Format::rgba16f})),
      irradiance_(emptyMap({gl::Format::rgba16f})),
      diffused_(emptyMap({gl::Format::rgba16f})),
      through_(emptyMap({gl::Format::rgba16f})) {
  specularTable_ = specularTexture();
  for (gl::Framebuffer& thin : thin_) thin = emptyMap({gl::Format::rgba16f});
}

bool LightPasses::holds(const LightKeys& keys, const GpuSkin& surface, const SkinQuality& quality) const {
  return done_ == keys && (byPoints_ || !wantsPoints(surface, quality));
}

bool LightPasses::shows(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) const {
  return finished() && holds(lightKeys(surface.parts().number, look, quality), surface, quality);
}

void LightPasses::begin(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) {
  fit(surface);
  if (!finished()) return;
  const LightKeys keys = lightKeys(surface.parts().number, look, quality);
  if (holds(keys, surface, quality)) return;
  adopt(look, quality);
  wanted_ = keys;
  nextLevel_ = 0;
  next_ = keys.material != done_.material       ? kMaterial
          : keys.lights != done_.lights         ? kLightMaps
          : keys.irradiance != done_.irradiance ? kIrradiance
                                                : kBlur;
}

void LightPasses::adopt(const SkinLook& look, const SkinQuality& quality) {
  if (!tables_.pigments || !(look.skin == look_.skin)) {
    skin_ = makeSkinMaterial(look.skin);
    tables_ = SkinTables(skin_);
  }
  look_ = look;
  quality_ = quality;
}

void LightPasses::spread(const GpuSkin& surface, const SkinOptions& skin,
                         const std::vector<glm::vec4>& irradiance) {
  fit(surface);
  SkinLook look{skin, {}, {}};
  look.lights.lights.resize(1);
  look.lights.lights[0] = {.colour = glm::vec3(0), .shadows = false};
  adopt(look, quality_);
  material_.clear(glm::vec4(1));
  irradiance_.clear({});
  irradiance_.setTexels(0, irradiance.data());
  wanted_ = {};
  nextLevel_ = 0;
  next_ = kBlur;
  while (step(surface)) {
  }
}

void LightPasses::fit(const GpuSkin& surface) {
  if (surface.parts().number == surface_) return;
  size_ = surface.parts().atlasSize();
  done_ = {};
  next_ = kDone;
  for (gl::Framebuffer* map : {&material_, &visibility_, &irradiance_, &diffused_, &thin_[0]}) {
    map->fit(size_);
    map->clear({});
  }
  // The others come to their size when they are drawn.
  for (gl::Framebuffer* map : {&thin_[1], &thin_[2], &through_}) map->fit({1, 1});
  levels_.reset(size_);
  surface_ = surface.parts().number;  // not where the driver could not hold one of these
}

bool LightPasses::step(const GpuSkin& surface) {
  if (finished()) return false;
  glDisable(GL_BLEND);
  gl::GpuTimer& timer = timers_[std::size_t(next_ == kBlur ? kDone + nextLevel_ : next_)];
  timer.begin();
  run(surface);
  timer.end();
  return true;
}

bool LightPasses::firstIsLeft() const { return byPoints_ || BlurLevels::sharpFirst(skin_.diffusion); }

void LightPasses::run(const GpuSkin& surface) {
  switch (next_) {
    case kMaterial:
      drawMaterial(surface);
      next_ = wanted_.lights == done_.lights ? kIrradiance : kLightMaps;
      break;
    case kLightMaps:
      drawLightMaps(surface);
      next_ = kVisibility;
      break;
    case kVisibility:
      drawVisibility(surface);
      next_ = kIrradiance;
      break;
    case kIrradiance:
      drawIrradiance(surface);
      next_ = kBlur;
      break;
    case kBlur:
      byPoints_ = wantsPoints(surface, quality_);
      if (byPoints_) {
        spreadPoints(surface);
        nextLevel_ = kLevels;
      } else {
        levels_.draw(surface, skin_.diffusion, nextLevel_++, irradiance_.colour(0));
      }
      if (nextLevel_ == kLevels) next_ = kThin;
      break;
    case kThin:
      blurThin(surface);
      next_ = kCombine;
      break;
    case kCombine:
      finish(surface);
      done_ = wanted_;
      next_ = kDone;
      break;
    default:
      break;
  }
}

void LightPasses::drawMaterial(const GpuSkin& surface) {
  const SkinOptions& o = look_.skin;
  gl::Program& p = programs_.use("skin/material.frag", {});
  bindTo(p, "positionMap", 0, surface.parts().position);
  bindTo(p, "normalMap", 1, surface.parts().normal);
  bindTo(p, "openMap", 2, surface.parts().open);
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

void LightPasses::drawLightMaps(const GpuSkin& surface) {
  for (std::size_t i = 0; i < LightRig::kMost; ++i)
    if (changed(i)) lightMaps_.draw(surface, look_.lights, i, quality_.shadowSize);
}

void LightPasses::drawVisibility(const GpuSkin& surface) {
  for (std::size_t i = 0; i < LightRig::kMost; ++i) {
    if (!changed(i)) continue;
    gl::Program& p = programs_.use(
        "skin/visibility.frag",
        {kindDefine(look_.lights), fmt::format("LIGHT {}", i), fmt::format("TAPS {}", quality_.shadowTaps)});
    bindTo(p, "positionMap", 0, surface.parts().position);
    bindTo(p, "normalMap", 1, surface.parts().normal);
    bindTo(p, "openMap", 2, surface.parts().open);
    bindTo(p, "depthMap", 3, lightMaps_.depth(i));
    bindTo(p, "placeMap", 4, lightMaps_.place());
    bindTo(p, "exitMap", 5, lightMaps_.exit(i));
    lightMaps_.setLights(p, look_.lights);
    p.set("density", float(look_.skin.density));
    visibility_.bind();
    glColorMask(i == 0, i == 1, i == 2, GL_TRUE);
    surface.parts().drawAtlas();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
}

void LightPasses::drawIrradiance(const GpuSkin& surface) {
  gl::Program& p = programs_.use("skin/irradiance.frag", {kindDefine(look_.lights)});
  bindTo(p, "positionMap", 0, surface.parts().position);
  bindTo(p, "normalMap", 1, surface.parts().normal);
  bindTo(p, "openMap", 2, surface.parts().open);
  bindTo(p, "albedoMap", 3, albedo());
  bindTo(p, "finishMap", 4, finish());
  bindTo(p, "specularTable", 5, specularTable_);
  bindTo(p, "visibilityMap", 6, visibility());
  lightMaps_.setLights(p, look_.lights);
  p.set("mixBefore", float(look_.skin.mix));
  irradiance_.bind();
  surface.parts().drawAtlas();
}

void LightPasses::spreadPoints(const GpuSkin& surface) {
  diffuseInBlocks(
      surface.parts().surface, skin_.diffusion, gl::readTexels(irradiance_.colour(0)), points_,
      [&](int level, const std::vector<glm::vec4>& map) { levels_.set(level, map, irradiance_.colour(0)); });
}

void LightPasses::setLevels(const GpuSkin& surface, const PointDiffusion::Levels& levels) {
  glDisable(GL_BLEND);
  for (int level = 1; level < kLevels; ++level)
    levels_.set(level, levels[std::size_t(level - 1)], irradiance_.colour(0));
  byPoints_ = true;
  finish(surface);
}

void LightPasses::finish(const GpuSkin& surface) {
  combine(surface, 0, diffused_);
  firstWeight_ = firstIsLeft() ? glm::vec3(skin_.diffusion.weights[0]) : glm::vec3(0);
  reference_ = false;
}

void LightPasses::blurThin(const GpuSkin& surface) {
  const gl::Texture& depth = visibility_.colour(1);
  if (surface.surface()->pointBased) return;  // blocks do not lie beside their neighbours
  if (look_.skin.thinModel == ThinModel::slab) {
    levels_.blur(surface, depth, kThinSmoothing * kThinSmoothing, kThinLooks, thin_[0]);
    return;
  }
  // The depth that Gaussian i meets is blurred as far as level i - 1.                                   [theory/skin.md, 7.2]
  const auto& v = skin_.diffusion.variances;
  double before = 0;
  const gl::Texture* from = &depth;
  for (std::size_t k = 0; k < thin_.size(); ++k) {
    const double added = std::max(v[k + 2] - before, 1e-4);
    levels_.blur(surface, *from, added, before, thin_[k]);
    before += added;
    from = &thin_[k].colour();
  }
}

void LightPasses::combine(const GpuSkin& surface, int part, const gl::Framebuffer& to) {
  const bool slab = look_.skin.thinModel == ThinModel::slab, points = surface.surface()->pointBased;
  const auto thin = [&](int i) -> const gl::Texture& {
    return points ? visibility_.colour(1) : thin_[slab ? 0 : std::size_t(i)].colour();
  };
  gl::Program& p = programs_.use("skin/combine.frag", {kindDefine(look_.lights), slab ? "SLAB" : "GAUSSIANS",
                                                       fmt::format("PART {}", part)});
  bindTo(p, "positionMap", 0, surface.parts().position);
  bindTo(p, "normalMap", 1, surface.parts().normal);
  bindTo(p, "albedoMap", 2, albedo());
  bindTo(p, "transmittance", 3, tables_.transmittance);
  const auto& d = skin_.diffusion;
  for (int i = 0; i < kLevels; ++i) {
    bindTo(p, fmt::format("levels[{}]", i), 4 + i, level(i));
    const bool left = i == 0 && firstIsLeft();
    p.set(fmt::format("weights[{}]", i).c_str(), left ? glm::vec3(0) : glm::vec3(d.weights[std::size_t(i)]));
  }
  for (int i = 0; i < 3; ++i) {
    bindTo(p, fmt::format("thinLevels[{}]", i), 10 + i, thin(i));
  }
  bindTo(p, "placeMap", 13, lightMaps_.place());
  lightMaps_.setLights(p, look_.lights);
  p.set("variances", glm::vec3(d.variances[3], d.variances[4], d.variances[5]));
  p.set("reach", float(SkinMaterial::kReach));
  p.set("translucency", float(look_.skin.translucency));
  p.set("mixBefore", float(look_.skin.mix));
  to.bind();
  surface.parts().drawShown();
}

void LightPasses::drawThrough(const GpuSkin& surface) {
  fitCleared(through_, size_);
  combine(surface, 1, through_);
}

void LightPasses::setDiffused(const std::vector<glm::vec4>& rgba) {
  diffused_.setTexels(0, rgba.data());
  reference_ = true;
}

SkinView::Timing LightPasses::timing() const {
  const auto of = [&](int timer) { return 1000 * timers_[std::size_t(timer)].seconds(); };
  SkinView::Timing timing{of(kMaterial),   of(kLightMaps), of(kVisibility),
                          of(kIrradiance), of(kThin),      of(kCombine)};
  for (int level = 0; level < kLevels; ++level) timing.blurs += of(kDone + level);
  return timing;
}

std::size_t LightPasses::bytes() const {
  const auto texels = [](const gl::Framebuffer& f) {
    return std::size_t(f.size().x) * std::size_t(f.size().y);
  };
  std::size_t sum = texels(material_) * 12 + texels(visibility_) * 16 + texels(irradiance_) * 8 +
                    texels(diffused_) * 8 + texels(through_) * 8;
  for (const gl::Framebuffer& f : thin_) sum += texels(f) * 8;
  return sum + levels_.bytes() + lightMaps_.bytes();
}

}  // namespace sonoskin
