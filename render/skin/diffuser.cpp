#include "render/skin/diffuser.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/skin/reference_diffusion.h"
#include "render/gl/read_pixels.h"
#include "render/skin/gpu_skin.h"

namespace sonoskin {
namespace {

// mm^2: what comes through a plate is spread by it; and what the looks for a depth spread over, a disc of 1 mm.
constexpr double kThinSmoothing = PointDiffusion::kSmoothVariance, kThinLooks = 0.25;

bool byPlates(const EnteringLight& light) { return light.look().skin.thinModel == ThinModel::slab; }

}  // namespace

DiffusionMethod diffusionFor(const GpuSkin& surface, const SkinQuality& quality) {
  const DiffusionMethod least =
      surface.surface()->pointBased ? DiffusionMethod::points : DiffusionMethod::blurs;
  return std::max(least, quality.diffusion);
}

Diffuser::Diffuser()
    : sum_(emptyMap({gl::Format::rgba16f})),
      through_(emptyMap({gl::Format::rgba16f})),
      byPoints_(emptyMap({gl::Format::rgba16f})) {
  for (gl::Framebuffer& thin : thin_) thin = emptyMap({gl::Format::rgba16f});
}

void Diffuser::fit(const GpuSkin& surface) {
  const glm::ivec2 size = surface.parts().atlasSize();
  next_ = kDone;
  summed_ = false;
  sum_.fit(size);
  sum_.clear({});
  // The others come to their size when they are drawn.
  for (gl::Framebuffer* map : {&thin_[0], &thin_[1], &thin_[2], &through_, &byPoints_}) map->fit({1, 1});
  levels_.reset(size);
}

void Diffuser::begin(DiffusionMethod method) {
  method_ = method;
  next_ = 0;
}

bool Diffuser::step(const GpuSkin& surface, const EnteringLight& light, const Progress& progress) {
  if (next_ == kDone) return false;
  gl::GpuTimer& timer = timers_[std::size_t(next_)];
  timer.begin();
  run(surface, light, progress);
  timer.end();
  return next_ != kDone;
}

void Diffuser::run(const GpuSkin& surface, const EnteringLight& light, const Progress& progress) {
  if (next_ < kLevels && method_ == DiffusionMethod::blurs) {
    summed_ = false;
    levels_.draw(surface, light.material().diffusion, next_++, light.irradiance());
  } else if (next_ < kLevels) {
    spreadPoints(surface, light, progress.part(0, method_ == DiffusionMethod::reference ? 0.1 : 1));
    next_ = kSum;
  } else if (next_ == kThin) {
    blurThin(surface, light);
    next_ = kSum;
  } else if (next_ == kSum) {
    sum(surface, light);
    next_ = method_ == DiffusionMethod::reference ? kReference : kDone;
  } else {
    integrate(surface, light, progress.part(0.1, 1));
    next_ = kDone;
  }
}

void Diffuser::spreadPoints(const GpuSkin& surface, const EnteringLight& light, const Progress& progress) {
  levels_.forget();
  set(spreadByPoints(surface.surface(), light.material().diffusion, light.look().skin.thinModel,
                     {gl::readTexels(light.irradiance()), gl::readTexels(light.thinness())}, points_,
                     progress),
      light);
}

void Diffuser::set(const PointsLight& spread, const EnteringLight& light) {
  const glm::ivec2 size = sum_.size();
  levels_.setFirst(light.irradiance());
  summed_ = !spread.sum.empty();
  if (summed_) {
    byPoints_.fit(size);
    byPoints_.setTexels(0, spread.sum.data());
    return;
  }
  for (int level = 1; level < kLevels; ++level) levels_.set(level, spread.levels[std::size_t(level - 1)]);
  for (std::size_t k = 0; k < thin_.size(); ++k) {
    std::vector<glm::vec4> thin = spread.thinness[k];
    for (glm::vec4& texel : thin) texel = glm::vec4(texel.a, texel.a, texel.a, 1);
    thin_[k].fit(size);
    thin_[k].setTexels(0, thin.data());
  }
}

void Diffuser::drawLevel(const GpuSkin& surface, const EnteringLight& light, int level) {
  if (levels_.has(level)) return;
  levels_.set(level, diffuseInBlocks(surface.surface(), light.material().diffusion,
                                     {gl::readTexels(light.irradiance())}, levelWeights(level), points_));
}

void Diffuser::integrate(const GpuSkin& surface, const EnteringLight& light, const Progress& progress) {
  const std::vector<glm::vec4> sum =
      referenceDiffusion(*surface.surface(), light.look().skin, gl::readTexels(light.irradiance()), progress);
  sum_.setTexels(0, sum.data());
  firstWeight_ = glm::vec3(0);  // the integral holds all six
}

void Diffuser::take(const GpuSkin& surface, const EnteringLight& light, const PointsLight& spread) {
  set(spread, light);
  method_ = DiffusionMethod::points;
  sum(surface, light);
}

void Diffuser::giveBack() {
  levels_.reset(sum_.size());
  for (gl::Framebuffer* map : {&thin_[0], &thin_[1], &thin_[2], &through_, &byPoints_}) map->fit({1, 1});
  points_ = {};
}

bool Diffuser::firstIsLeft(const EnteringLight& light) const {
  return method_ > DiffusionMethod::blurs || BlurLevels::sharpFirst(light.material().diffusion);
}

void Diffuser::sum(const GpuSkin& surface, const EnteringLight& light) {
  combine(surface, light, Part::all, sum_);
  firstWeight_ = firstIsLeft(light) ? glm::vec3(light.material().diffusion.weights[0]) : glm::vec3(0);
}

void Diffuser::blurThin(const GpuSkin& surface, const EnteringLight& light) {
  const gl::Texture& depth = light.thinness();
  if (byPlates(light)) {
    levels_.blur(surface, depth, kThinSmoothing, kThinLooks, thin_[0]);
    return;
  }
  // The depth that Gaussian i meets is blurred as far as level i - 1.                                   [theory/skin.md, 7.2]
  const auto& v = light.material().diffusion.variances;
  double before = 0;
  const gl::Texture* from = &depth;
  for (std::size_t k = 0; k < thin_.size(); ++k) {
    const double added = std::max(v[k + 2] - before, 1e-4);
    levels_.blur(surface, *from, added, before, thin_[k]);
    before += added;
    from = &thin_[k].colour();
  }
}

void Diffuser::combine(const GpuSkin& surface, const EnteringLight& light, Part part,
                       const gl::Framebuffer& to) {
  const bool plates = byPlates(light);
  std::vector<std::string> defines{kindDefine(light.look().lights), plates ? "SLAB" : "GAUSSIANS",
                                   fmt::format("PART {}", part == Part::all ? 0 : 1)};
  if (summed_) defines.emplace_back("SUMMED");
  gl::Program& p = programs_.use("skin/combine.frag", defines);
  bindTo(p, "positionMap", 0, surface.parts().position);
  bindTo(p, "normalMap", 1, surface.parts().normal);
  bindTo(p, "albedoMap", 2, light.albedo());
  bindTo(p, "transmittance", 3, light.tables().transmittance);
  if (summed_)
    bindTo(p, "summed", 4, byPoints_.colour());
  else
    bindLevels(p, light);
  bindTo(p, "placeMap", 13, light.lightMaps().place());
  light.lightMaps().setLights(p, light.look().lights);
  const GaussianSum& d = light.material().diffusion;
  p.set("variances", glm::vec3(d.variances[3], d.variances[4], d.variances[5]));
  p.set("reach", float(SkinMaterial::kReach));
  p.set("translucency", float(light.look().skin.translucency));
  p.set("mixBefore", float(light.look().skin.mix));
  to.bind();
  surface.parts().drawShown();
}

void Diffuser::bindLevels(gl::Program& p, const EnteringLight& light) {
  const GaussianSum& d = light.material().diffusion;
  for (int i = 0; i < kLevels; ++i) {
    bindTo(p, fmt::format("levels[{}]", i), 4 + i, level(i));
    const bool left = i == 0 && firstIsLeft(light);
    p.set(fmt::format("weights[{}]", i).c_str(), left ? glm::vec3(0) : glm::vec3(d.weights[std::size_t(i)]));
  }
  for (int i = 0; i < 3; ++i)
    bindTo(p, fmt::format("thinLevels[{}]", i), 10 + i, thin_[byPlates(light) ? 0 : std::size_t(i)].colour());
}

void Diffuser::drawThrough(const GpuSkin& surface, const EnteringLight& light) {
  fitCleared(through_, surface.parts().atlasSize());
  combine(surface, light, Part::through, through_);
}

double Diffuser::levelTime() const {
  double seconds = 0;
  for (int pass = 0; pass <= kThin; ++pass) seconds += timers_[std::size_t(pass)].seconds();
  return 1000 * seconds;
}

double Diffuser::sumTime() const { return 1000 * timers_[kSum].seconds(); }

std::size_t Diffuser::bytes() const {
  std::size_t sum = (sum_.texels() + through_.texels() + byPoints_.texels()) * 8;
  for (const gl::Framebuffer& f : thin_) sum += f.texels() * 8;
  return sum + levels_.bytes();
}

}  // namespace sonoskin
