#include "render/skin/blur_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/skin/blur_kernel.h"
#include "render/skin/gpu_skin.h"

namespace sonoskin {

gl::Framebuffer emptyMap(std::vector<gl::Format> formats) {
  return gl::Framebuffer({.size = {1, 1}, .colours = std::move(formats), .filter = gl::Filter::linear});
}

void fitCleared(gl::Framebuffer& map, glm::ivec2 size) {
  if (map.size() == size) return;
  map.fit(size);
  map.clear({});
}

namespace {

// How many times the texels of a map are doubled for a blur of so many texels.
int coarseness(double wide) { return wide < 2 ? 0 : wide < 6 ? 1 : 2; }

}  // namespace

BlurLevels::BlurLevels() {
  for (gl::Framebuffer& map : maps_) map = emptyMap({gl::Format::rgba16f});
  for (gl::Framebuffer& spare : spares_) spare = emptyMap({gl::Format::rgba16f});
}

void BlurLevels::reset(glm::ivec2 size) {
  size_ = size;
  for (gl::Framebuffer& map : maps_) map.fit({1, 1});
  for (gl::Framebuffer& spare : spares_) spare.fit({1, 1});
}

void BlurLevels::forget() {
  for (gl::Framebuffer& map : maps_) map.fit({1, 1});
  std::fill(shown_.begin() + 1, shown_.end(), nullptr);
}

// Spread: one blur. Lengths in mm.
//   sigma, smoothed   of this blur, and of those before
//   from, to          texels of what is read and drawn
struct BlurLevels::Spread {
  double sigma = 0, smoothed = 0, from = 0, to = 0;
};

void BlurLevels::blur(const GpuSkin& surface, const gl::Texture& from, const Spread& spread,
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

// What reading between the texels of a coarse map blurs is taken off.                            [theory/skin.md, 5.4]
void BlurLevels::draw(const GpuSkin& surface, const GaussianSum& sum, int level,
                      const gl::Texture& irradiance) {
  const auto at = std::size_t(level);
  const double texel = double(surface.surface()->atlas.texel);
  const bool first = level == 0;
  stored_[at] = first ? 0 : stored_[at - 1];
  shift_[at] = first ? 0 : shift_[at - 1];
  shown_[at] = first ? &irradiance : shown_[at - 1];
  const double variance = sum.variances[at], before = stored_[at];
  const double apart = variance - (first ? 0 : sum.variances[at - 1]);
  if (first ? sharpFirst(sum) : apart < 1e-6) return;
  const double wide = std::sqrt(apart) / texel;
  const double from = std::ldexp(texel, shift_[at]);
  shift_[at] = std::max(shift_[at], coarseness(wide));
  const double to = std::ldexp(texel, shift_[at]);
  stored_[at] = variance - (shift_[at] > 0 ? to * to / 6 : 0);
  gl::Framebuffer &map = maps_[at], &spare = spares_[std::size_t(shift_[at])];
  for (gl::Framebuffer* f : {&map, &spare}) fitCleared(*f, coarse(shift_[at]));
  blur(surface, *shown_[at], {std::sqrt(stored_[at] - before), std::sqrt(before), from, to}, spare, map);
  shown_[at] = &map.colour();
}

void BlurLevels::set(int level, const std::vector<glm::vec4>& texels) {
  const auto at = std::size_t(level);
  maps_[at].fit(size_);
  maps_[at].setTexels(0, texels.data());
  shown_[at] = &maps_[at].colour();
}

void BlurLevels::blur(const GpuSkin& surface, const gl::Texture& from, double added, double before,
                      gl::Framebuffer& to) {
  const double fine = double(surface.surface()->atlas.texel);
  const double read = fine * double(size_.x) / double(from.size().x);
  const int shift = coarseness(std::sqrt(added) / fine);
  gl::Framebuffer& spare = spares_[std::size_t(shift)];
  for (gl::Framebuffer* f : {&to, &spare}) fitCleared(*f, coarse(shift));
  blur(surface, from, {std::sqrt(added), std::sqrt(before), read, std::ldexp(fine, shift)}, spare, to);
}

std::size_t BlurLevels::bytes() const {
  std::size_t texels = 0;
  for (const auto& f : maps_) texels += f.texels();
  for (const auto& f : spares_) texels += f.texels();
  return 8 * texels;
}

}  // namespace sonoskin
