#include "render/skin/light_passes.h"

#include <glad/gl.h>

#include "core/base/free_memory.h"
#include "render/skin/gpu_skin.h"

namespace sonoskin {

bool LightPasses::holds(const LightKeys& keys, const GpuSkin& surface, const SkinQuality& quality) const {
  return done_ == keys && diffuser_.method() >= diffusionFor(surface, quality);
}

bool LightPasses::shows(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) const {
  return finished() && holds(lightKeys(surface.parts().number, look, quality), surface, quality);
}

void LightPasses::begin(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) {
  fit(surface);
  if (!finished()) return;
  const LightKeys keys = lightKeys(surface.parts().number, look, quality);
  if (holds(keys, surface, quality)) return;
  entering_.adopt(look, quality);
  diffuser_.begin(diffusionFor(surface, quality));
  quality_ = quality;
  wanted_ = keys;
  next_ = keys.material != done_.material       ? kMaterial
          : keys.lights != done_.lights         ? kLightMaps
          : keys.irradiance != done_.irradiance ? kIrradiance
                                                : kDiffusion;
}

void LightPasses::giveBack(GpuSkin& surface) {
  if (next_ != kDiffusion && !finished()) return;
  entering_.giveBackMaps();
  if (diffuser_.method() != DiffusionMethod::blurs) surface.giveBackSky();
  if (finished()) {
    entering_.giveBackLight();
    diffuser_.giveBack();
    surface.giveBackMaps();
  }
  glFinish();  // drivers keep what passes under way still read
  returnFreeMemory();
}

void LightPasses::spread(const GpuSkin& surface, const SkinOptions& skin,
                         const std::vector<glm::vec4>& irradiance) {
  fit(surface);
  SkinLook look{skin, {}, {}};
  look.lights.lights.resize(1);
  look.lights.lights[0] = {.colour = glm::vec3(0), .shadows = false};
  entering_.adopt(look, quality_);
  entering_.set(irradiance);
  diffuser_.begin(diffusionFor(surface, quality_));
  wanted_ = {};
  next_ = kDiffusion;
  while (step(surface)) {
  }
}

void LightPasses::take(const GpuSkin& surface, const PointsLight& spread) {
  glDisable(GL_BLEND);
  diffuser_.take(surface, entering_, spread);
}

void LightPasses::fit(const GpuSkin& surface) {
  if (surface.parts().number == surface_) return;
  done_ = {};
  next_ = kDone;
  entering_.fit(surface);
  diffuser_.fit(surface);
  surface_ = surface.parts().number;  // not where the driver could not hold one of the maps
}

bool LightPasses::step(const GpuSkin& surface, const Progress& progress) {
  if (finished()) return false;
  glDisable(GL_BLEND);
  if (next_ == kDiffusion) {
    run(surface, progress);
    return true;
  }
  gl::GpuTimer& timer = timers_[std::size_t(next_)];
  timer.begin();
  run(surface, progress);
  timer.end();
  return true;
}

void LightPasses::run(const GpuSkin& surface, const Progress& progress) {
  switch (next_) {
    case kMaterial:
      entering_.drawMaterial(surface);
      next_ = wanted_.lights == done_.lights ? kIrradiance : kLightMaps;
      break;
    case kLightMaps:
      forEachChanged([&](std::size_t i) { entering_.drawLightMap(surface, i); });
      next_ = kVisibility;
      break;
    case kVisibility:
      forEachChanged([&](std::size_t i) { entering_.drawVisibility(surface, i); });
      next_ = kIrradiance;
      break;
    case kIrradiance:
      entering_.drawIrradiance(surface);
      next_ = kDiffusion;
      break;
    case kDiffusion:
      if (diffuser_.step(surface, entering_, progress)) break;
      done_ = wanted_;
      next_ = kDone;
      break;
    default:
      break;
  }
}

SkinView::Timing LightPasses::timing() const {
  const auto of = [&](Pass pass) { return 1000 * timers_[std::size_t(pass)].seconds(); };
  return {of(kMaterial),   of(kLightMaps),        of(kVisibility),
          of(kIrradiance), diffuser_.levelTime(), diffuser_.sumTime()};
}

}  // namespace sonoskin
