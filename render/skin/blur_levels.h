#pragma once

#include <array>

#include "core/skin/gaussian_sum.h"
#include "render/gl/framebuffer.h"
#include "render/skin/pass_programs.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// emptyMap: a map of one texel that is read between its texels.
gl::Framebuffer emptyMap(std::vector<gl::Format> formats);
// fitCleared: brings a map to its size. Passes draw where the surface is: the rest must be empty before.
void fitCleared(gl::Framebuffer& map, glm::ivec2 size);

// BlurLevels: light in an atlas after each Gaussian of a sum, each made from the one before.
//   maps   rgba16f, premultiplied by coverage; wide blurs have half or a quarter of the texels along a side
class BlurLevels {
 public:
  static constexpr int kLevels = GaussianSum::kCount;
  // kSharp: variance up to which the first Gaussian is taken as none at all, mm^2: it is narrower than a texel then, and
  // the final pass has it at the picture's resolution.
  static constexpr double kSharp = 0.02;
  static bool sharpFirst(const GaussianSum& sum) { return sum.variances[0] <= kSharp; }

  BlurLevels();
  // reset: forgets all maps; the next ones have `size` texels where they are finest.
  void reset(glm::ivec2 size);
  // forget: there are no levels but the first.
  void forget();
  // draw: level `level` from the one before, or level 0 from the irradiance, which must outlive it.
  void draw(const GpuSkin& surface, const GaussianSum& sum, int level, const gl::Texture& irradiance);
  // setFirst, set: level 0 is the irradiance; fills another level instead of drawing it.
  void setFirst(const gl::Texture& irradiance) { shown_[0] = &irradiance; }
  void set(int level, const std::vector<glm::vec4>& texels);
  // has: whether a level is there.
  bool has(int level) const { return shown_[std::size_t(level)] != nullptr; }
  const gl::Texture& level(int level) const { return *shown_[std::size_t(level)]; }

  // blur: any map, by Gaussians of `added` mm^2 after `before`; as coarse as that allows.
  void blur(const GpuSkin& surface, const gl::Texture& from, double added, double before,
            gl::Framebuffer& to);
  std::size_t bytes() const;

 private:
  struct Spread;
  void blur(const GpuSkin& surface, const gl::Texture& from, const Spread& spread, gl::Framebuffer& spare,
            gl::Framebuffer& to);
  glm::ivec2 coarse(int shift) const { return (size_ + (1 << shift) - 1) >> shift; }

  PassPrograms programs_{"skin/atlas.vert"};
  glm::ivec2 size_{1};
  std::array<gl::Framebuffer, kLevels> maps_;
  std::array<gl::Framebuffer, 3> spares_;            // by coarseness
  std::array<const gl::Texture*, kLevels> shown_{};  // equal variances share a map
  std::array<double, kLevels> stored_{};             // variance of what each level holds, mm^2
  std::array<int, kLevels> shift_{};                 // its texels are 2^shift as long
};

}  // namespace sonoskin
