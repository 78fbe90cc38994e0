#pragma once

#include <array>

#include "core/base/progress.h"
#include "render/gl/gpu_timer.h"
#include "render/skin/blur_levels.h"
#include "render/skin/entering_light.h"
#include "render/skin/points_light.h"

namespace sonoskin {

// SpreadLight: what a diffuser gives to the final pass.
//   map          the light that has spread and comes through thin parts: over the atlas, linear RGB premultiplied by
//                coverage in a
//   firstWeight  of the first Gaussian where the map lacks it: it is narrower than texels, and the final pass adds it at
//                the picture's own resolution; 0 where the map holds it
struct SpreadLight {
  const gl::Texture& map;
  glm::vec3 firstWeight{0};
};

// diffusionFor: the method that a surface is to be shown with: an atlas of blocks cannot be blurred.
DiffusionMethod diffusionFor(const GpuSkin& surface, const SkinQuality& quality);

// Diffuser: from the light that enters the skin to the light that has spread below it, by any DiffusionMethod, one pass at
// a time.
//   levels and depth, by blurs or points -> weighted sum -> the reference in the place of the sum
// Points bring the sum of the levels, for plates, and the depth beside it. The first Gaussian is the same for both.
class Diffuser {
 public:
  Diffuser();

  // fit: empty maps for another surface.
  void fit(const GpuSkin& surface);
  // begin: light is to be spread anew.
  void begin(DiffusionMethod method);
  // step: runs the next pass; whether more are left.
  //   progress   of points and reference, the CPU's
  //   errors     Cancelled: the same step comes next
  bool step(const GpuSkin& surface, const EnteringLight& light, const Progress& progress = {});
  // take: the same light that was spread elsewhere, from point to point, in the place of what is there; nothing may be left
  // of what was begun.
  void take(const GpuSkin& surface, const EnteringLight& light, const PointsLight& spread);

  // giveBack: the memory of all but the result. Afterwards no light can be spread, nor a level or `through` be drawn.
  void giveBack();

  // method: by which the light was spread last.
  DiffusionMethod method() const { return method_; }
  SpreadLight result() const { return {sum_.colour(), firstWeight_}; }

  static constexpr int kLevels = BlurLevels::kLevels;
  // level: 0 the irradiance, i the first i+1 Gaussians' blur; premultiplied by coverage in a; wide blurs have coarser maps.
  // drawLevel: makes it, where points have left out the single levels.
  const gl::Texture& level(int level) const { return levels_.level(level); }
  void drawLevel(const GpuSkin& surface, const EnteringLight& light, int level);
  // drawThrough: makes `through`: light through thin parts alone.
  void drawThrough(const GpuSkin& surface, const EnteringLight& light);
  const gl::Texture& through() const { return through_.colour(); }

  // levelTime, sumTime: milliseconds of the GPU, of blurs, the depth's among them, and of the sum.
  double levelTime() const;
  double sumTime() const;
  std::size_t bytes() const;

 private:
  enum Pass { kThin = kLevels, kSum, kReference, kDone };  // a level's number before them
  enum class Part { all, through };
  void run(const GpuSkin& surface, const EnteringLight& light, const Progress& progress);
  void spreadPoints(const GpuSkin& surface, const EnteringLight& light, const Progress& progress);
  void integrate(const GpuSkin& surface, const EnteringLight& light, const Progress& progress);
  void blurThin(const GpuSkin& surface, const EnteringLight& light);
  void sum(const GpuSkin& surface, const EnteringLight& light);
  void combine(const GpuSkin& surface, const EnteringLight& light, Part part, const gl::Framebuffer& to);
  void bindLevels(gl::Program& program, const EnteringLight& light);
  // set: uploads what points have spread.
  void set(const PointsLight& spread, const EnteringLight& light);
  // firstIsLeft: whether the final pass adds the first Gaussian.
  bool firstIsLeft(const EnteringLight& light) const;

  PassPrograms programs_{"skin/atlas.vert"};
  DiffusionMethod method_ = DiffusionMethod::blurs;
  int next_ = kDone;
  std::array<gl::GpuTimer, kDone> timers_;  // by pass
  glm::vec3 firstWeight_{0};
  gl::Framebuffer sum_, through_;
  gl::Framebuffer byPoints_;  // PointsLight::sum
  bool summed_ = false;       // whether that stands for levels and depth
  BlurLevels levels_;
  std::array<gl::Framebuffer, 3> thin_;
  BlockDiffusion points_;  // for finished pictures and atlases that cannot be blurred
};

}  // namespace sonoskin
