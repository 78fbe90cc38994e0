#include "render/skin/light_passes.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <cmath>

#include "core/pipeline/parameter_key.h"
#include "render/gl/read_pixels.h"
#include "render/skin/blur_kernel.h"
#include "render/skin/gpu_skin.h"

namespace sonoskin {
namespace {

constexpr double kThinSmoothing = 0.75;  // mm: what comes through a plate is spread by it

Hasher& addVector(Hasher& hasher, const glm::vec3& v) { return hasher.add(v.x).add(v.y).add(v.z); }

gl::Framebuffer map(std::vector<gl::Format> formats) {
  return gl::Framebuffer({.size = {1, 1}, .colours = std::move(formats), .filter = gl::Filter::linear});
}

// Maps are drawn where the surface is: the rest must be empty before.
void fitCleared(gl::Framebuffer& map, glm::ivec2 size) {
  if (map.size() == size) return;
  map.fit(size);
  map.clear({});
}

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
    : material_(map({gl::Format::rgba16f, gl::Format::rgba8})),
      irradiance_(map({gl::Format::rgba16f, gl::Format::rgba8, gl::Format::rgba16f})),
      diffused_(map({gl::Format::rgba16f})),
      through_(map({gl::Format::rgba16f})) {
  specularTable_ = specularTexture();
  for (gl::Framebuffer& spare : spares_) spare = map({gl::Format::rgba16f});
  for (gl::Framebuffer& level : levels_) level = map({gl::Format::rgba16f});
  for (gl::Framebuffer& thin : thin_) thin = map({gl::Format::rgba16f});
}

LightPasses::Keys LightPasses::keysOf(const GpuSkin& surface, const SkinLook& look,
                                      const SkinQuality& quality) {
  // What only the final pass reads, or only the blurs, must not light the skin anew.
  SkinOptions material = look.skin;
  material.detail = 0;
  SkinOptions before = material;
  before.profile = {};
  before.width = before.translucency = 0;
  before.thinModel = {};
  before.gaussians = 1;
  before.absorption = before.scattering = {1, 1, 1};
  Keys keys;
  Hasher made("skin material");
  made.add(surface.parts().number);
  addOptions(made, before);
  addOptions(made, look.landmarks);
  keys.material = made.key();
  Hasher maps("light maps");
  maps.add(surface.parts().number).add(quality.shadowSize);
  for (const SkinLight& light : look.lights.lights)
    addVector(maps, light.position).add(light.kind).add(light.shadows);
  keys.lightMaps = maps.key();
  Hasher lit("irradiance");
  lit.add(keys.material).add(keys.lightMaps).add(quality.shadowTaps);
  for (const SkinLight& light : look.lights.lights)
    addVector(lit, light.colour).add(light.reach).add(light.softness);
  for (const glm::vec3& c : look.lights.environment) addVector(lit, c);
  keys.irradiance = lit.key();
  Hasher spread("spread");
  spread.add(keys.irradiance);
  addOptions(spread, material);
  keys.blur = spread.key();
  return keys;
}

bool LightPasses::shows(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) const {
  return finished() && done_ == keysOf(surface, look, quality);
}

void LightPasses::begin(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) {
  fit(surface);
  if (!finished()) return;
  const Keys keys = keysOf(surface, look, quality);
  if (keys == done_) return;
  adopt(look, quality);
  wanted_ = keys;
  nextLevel_ = 1;
  next_ = !(keys.material == done_.material)       ? kMaterial
          : !(keys.lightMaps == done_.lightMaps)   ? kLightMaps
          : !(keys.irradiance == done_.irradiance) ? kIrradiance
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
  nextLevel_ = 1;
  next_ = kBlur;
  while (step(surface)) {
  }
}

void LightPasses::fit(const GpuSkin& surface) {
  if (surface.parts().number == surface_) return;
  surface_ = surface.parts().number;
  size_ = surface.parts().atlasSize();
  done_ = {};
  next_ = kDone;
  for (gl::Framebuffer* map : {&material_, &irradiance_, &diffused_, &thin_[0]}) {
    map->fit(size_);
    map->clear({});
  }
  // The others come to their size when they are drawn.
  for (gl::Framebuffer* map : {&thin_[1], &thin_[2], &through_}) map->fit({1, 1});
  for (gl::Framebuffer& map : levels_) map.fit({1, 1});
  for (gl::Framebuffer& map : spares_) map.fit({1, 1});
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

void LightPasses::run(const GpuSkin& surface) {
  switch (next_) {
    case kMaterial:
      drawMaterial(surface);
      next_ = wanted_.lightMaps == done_.lightMaps ? kIrradiance : kLightMaps;
      break;
    case kLightMaps:
      lightMaps_.draw(surface, look_.lights, quality_.shadowSize);
      next_ = kIrradiance;
      break;
    case kIrradiance:
      drawIrradiance(surface);
      next_ = kBlur;
      break;
    case kBlur:
      if (surface.surface()->pointBased) {
        spreadPoints(surface);
        nextLevel_ = kLevels;
      } else {
        blurLevel(surface, nextLevel_++);
      }
      if (nextLevel_ == kLevels) next_ = kThin;
      break;
    case kThin:
      blurThin(surface);
      next_ = kCombine;
      break;
    case kCombine:
      combine(surface, 0, diffused_);
      reference_ = false;
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

void LightPasses::drawIrradiance(const GpuSkin& surface) {
  gl::Program& p = programs_.use("skin/irradiance.frag",
                                 {kindDefine(look_.lights), fmt::format("TAPS {}", quality_.shadowTaps)});
  bindTo(p, "positionMap", 0, surface.parts().position);
  bindTo(p, "normalMap", 1, surface.parts().normal);
  bindTo(p, "openMap", 2, surface.parts().open);
  bindTo(p, "albedoMap", 3, albedo());
  bindTo(p, "finishMap", 4, finish());
  bindTo(p, "specularTable", 5, specularTable_);
  for (int i = 0; i < LightRig::kMost; ++i) {
    bindTo(p, fmt::format("depthMaps[{}]", i), 6 + i, lightMaps_.depth(i));
    bindTo(p, fmt::format("placeMaps[{}]", i), 9 + i, lightMaps_.place(i));
    bindTo(p, fmt::format("exitMaps[{}]", i), 12 + i, lightMaps_.exit(i));
  }
  lightMaps_.setLights(p, look_.lights);
  p.set("mixBefore", float(look_.skin.mix));
  p.set("density", float(look_.skin.density));
  irradiance_.bind();
  surface.parts().drawAtlas();
}

const gl::Texture& LightPasses::level(int level) const {
  const int shown = shownLevel_[std::size_t(level)];
  return shown == 0 ? irradiance_.colour(0) : levels_[std::size_t(shown - 1)].colour();
}

// Spread: one blur. Lengths in mm.
//   sigma, smoothed   of this blur, and of those before
//   from, to          texels of what is read and drawn
struct LightPasses::Spread {
  double sigma = 0, smoothed = 0, from = 0, to = 0;
};

void LightPasses::blur(const GpuSkin& surface, const gl::Texture& from, const Spread& spread,
                       gl::Framebuffer& spare, gl::Framebuffer& to) {
  const BlurKernel kernel = makeBlurKernel(blurSpacing(spread.sigma, spread.from, spread.smoothed));
  gl::Program& p = programs_.use("skin/blur.frag", {fmt::format("TAPS {}", kernel.places.size() - 1)});
  bindTo(p, "stretchMap", 1, surface.parts().stretch);
  p.set("places", std::span<const float>(kernel.places));
  p.set("weights", std::span<const float>(kernel.weights));
  p.set("size", glm::vec2(to.size()));
  // A look between two texels blurs too: by f (1 - f) texels^2 at the share f of the way, a sixth on average. On the way
  // to a coarser map the middle is a corner of texels as well.
  const double others = 1 - double(kernel.weights[0]), variance = spread.sigma * spread.sigma;
  const bool coarser = spread.to > spread.from;
  const auto along = [&](double texel, double corner) {
    const double looks = others * texel * texel / 6 + corner * spread.from * spread.from / 4;
    return float(std::sqrt(std::max(variance - looks, 0.25 * variance)));
  };
  const auto draw = [&](const gl::Texture& light, const glm::vec2& axis, float sigma,
                        const gl::Framebuffer& target) {
    bindTo(p, "light", 0, light);
    p.set("axis", axis);
    p.set("sigma", sigma);
    target.bind();
    surface.parts().drawAtlas();
  };
  draw(from, {1, 0}, along(spread.from, coarser ? double(kernel.weights[0]) : 0), spare);
  draw(spare.colour(), {0, 1}, along(spread.to, coarser ? 1 : 0), to);
}

// The narrowest Gaussian is taken as sharp: it is narrower than a texel, and the final pass has it at the picture's
// resolution. So the second one gets its whole variance. Wide blurs have maps of half or a quarter of the texels along a
// side; what reading between those blurs is taken off.                                 [skin specification, section 8]
void LightPasses::blurLevel(const GpuSkin& surface, int level) {
  const auto at = std::size_t(level);
  const double texel = double(surface.surface()->atlas.texel);
  const auto& v = skin_.diffusion.variances;
  if (level == 1) stored_.fill(0), shift_.fill(0);
  stored_[at] = stored_[at - 1];
  shift_[at] = shift_[at - 1];
  shownLevel_[0] = 0;
  shownLevel_[at] = shownLevel_[at - 1];
  if (v[at] - v[at - 1] < 1e-6) return;
  const double wide = std::sqrt(v[at] - v[at - 1]) / texel;
  shift_[at] = std::max(shift_[at - 1], wide < 3 ? 0 : wide < 6 ? 1 : 2);
  const double from = std::ldexp(texel, shift_[at - 1]), to = std::ldexp(texel, shift_[at]);
  const double wanted = v[at] - (shift_[at] > 0 ? to * to / 6 : 0), added = wanted - stored_[at - 1];
  gl::Framebuffer &map = levels_[at - 1], &spare = spares_[std::size_t(shift_[at])];
  for (gl::Framebuffer* f : {&map, &spare}) fitCleared(*f, coarse(shift_[at]));
  blur(surface, this->level(level - 1), {std::sqrt(added), std::sqrt(stored_[at - 1]), from, to}, spare, map);
  stored_[at] = wanted;
  shownLevel_[at] = level;
}

void LightPasses::spreadPoints(const GpuSkin& surface) {
  const auto read = gl::readFloats(irradiance_.colour(0), 4);
  std::vector<glm::vec4> irradiance(read.size() / 4);
  for (std::size_t i = 0; i < irradiance.size(); ++i)
    irradiance[i] = {read[4 * i], read[4 * i + 1], read[4 * i + 2], read[4 * i + 3]};
  const auto& spread = diffuseInBlocks(surface.parts().surface, skin_.diffusion, irradiance, points_);
  for (std::size_t level = 1; level < kLevels; ++level) {
    fitCleared(levels_[level - 1], size_);
    levels_[level - 1].setTexels(0, spread[level - 1].data());
    shownLevel_[level] = int(level);
  }
}

void LightPasses::blurThin(const GpuSkin& surface) {
  const gl::Texture& depth = irradiance_.colour(2);
  if (surface.surface()->pointBased) return;  // blocks do not lie beside their neighbours
  const double texel = double(surface.surface()->atlas.texel);
  fitCleared(spares_[0], size_);
  if (look_.skin.thinModel == ThinModel::slab) {
    blur(surface, depth, {kThinSmoothing, 0, texel, texel}, spares_[0], thin_[0]);
    return;
  }
  // The depth that Gaussian i meets is blurred as far as level i - 1.                       [skin specification, section 9.2]
  const auto& v = skin_.diffusion.variances;
  for (gl::Framebuffer& thin : thin_) fitCleared(thin, size_);
  double before = 0;
  const gl::Texture* from = &depth;
  for (std::size_t k = 0; k < thin_.size(); ++k) {
    const double added = std::max(v[k + 2] - before, 1e-4);
    blur(surface, *from, {std::sqrt(added), std::sqrt(before), texel, texel}, spares_[0], thin_[k]);
    before += added;
    from = &thin_[k].colour();
  }
}

void LightPasses::combine(const GpuSkin& surface, int part, const gl::Framebuffer& to) {
  const bool slab = look_.skin.thinModel == ThinModel::slab, points = surface.surface()->pointBased;
  const auto thin = [&](int i) -> const gl::Texture& {
    return points ? irradiance_.colour(2) : thin_[slab ? 0 : std::size_t(i)].colour();
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
    p.set(fmt::format("weights[{}]", i).c_str(), glm::vec3(d.weights[std::size_t(i)]));
  }
  for (int i = 0; i < 3; ++i) {
    bindTo(p, fmt::format("thinLevels[{}]", i), 10 + i, thin(i));
    bindTo(p, fmt::format("placeMaps[{}]", i), 13 + i, lightMaps_.place(i));
  }
  lightMaps_.setLights(p, look_.lights);
  p.set("variances", glm::vec3(d.variances[3], d.variances[4], d.variances[5]));
  p.set("reach", float(SkinMaterial::kReach));
  p.set("translucency", float(look_.skin.translucency));
  p.set("mixBefore", float(look_.skin.mix));
  to.bind();
  surface.parts().drawAtlas();
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
  SkinView::Timing timing{of(kMaterial), of(kLightMaps), of(kIrradiance), of(kThin), of(kCombine), 0};
  for (int level = 1; level < kLevels; ++level) timing.blurs += of(kDone + level);
  return timing;
}

std::size_t LightPasses::bytes() const {
  const auto texels = [](const gl::Framebuffer& f) {
    return std::size_t(f.size().x) * std::size_t(f.size().y);
  };
  std::size_t sum =
      texels(material_) * 12 + texels(irradiance_) * 20 + texels(diffused_) * 8 + texels(through_) * 8;
  for (const gl::Framebuffer& f : levels_) sum += texels(f) * 8;
  for (const gl::Framebuffer& f : spares_) sum += texels(f) * 8;
  for (const gl::Framebuffer& f : thin_) sum += texels(f) * 8;
  return sum + lightMaps_.bytes();
}

}  // namespace sonoskin
