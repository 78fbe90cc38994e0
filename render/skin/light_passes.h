#pragma once

#include <array>

#include "core/skin/block_diffusion.h"
#include "core/skin/skin_material.h"
#include "render/gl/gpu_timer.h"
#include "render/skin/blur_levels.h"
#include "render/skin/light_keys.h"
#include "render/skin/light_maps.h"
#include "render/skin/pass_programs.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// SkinTables: a material's tables as textures.
struct SkinTables {
  gl::Texture pigments, transmittance;
  SkinTables() = default;
  explicit SkinTables(const SkinMaterial& material);
};

// LightPasses: from lights and material to the light in the atlas, one pass at a time; what has not changed is kept.
//   material -> light maps -> visibility -> irradiance -> blurs 2 to 6 -> blurs of the depth -> weighted sum
// None of it depends on the camera. A light that moves leaves the maps and the visibility of the others.
class LightPasses {
 public:
  LightPasses();

  // begin: what the steps work toward. A look whose passes are under way is finished first, so that light that is
  // dragged about is seen at all.
  void begin(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality);
  // step: runs the next pass; false when nothing was left to do.
  bool step(const GpuSkin& surface);
  bool finished() const { return next_ == kDone; }
  // shows: whether the finished maps are those of a look.
  bool shows(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) const;

  static constexpr int kLevels = BlurLevels::kLevels;
  // level: 0 the irradiance, i the first i+1 Gaussians' blur; premultiplied by coverage in a;
  // wide blurs have coarser maps.
  const gl::Texture& level(int level) const { return levels_.level(level); }
  const gl::Texture& albedo() const { return material_.colour(0); }
  const gl::Texture& finish() const { return material_.colour(1); }
  const gl::Texture& visibility() const { return visibility_.colour(0); }
  // diffused: Gaussians 2 to 6 and light through thin parts, of the last look that was finished.
  const gl::Texture& diffused() const { return diffused_.colour(); }
  // drawThrough: makes `through`: light through thin parts alone.
  void drawThrough(const GpuSkin& surface);
  const gl::Texture& through() const { return through_.colour(); }
  // firstWeight: of the first Gaussian where the final pass adds it.
  glm::vec3 firstWeight() const { return firstWeight_; }
  LightMaps& lightMaps() { return lightMaps_; }
  // spread, setLevels, byPoints, setDiffused: see SkinView.
  void spread(const GpuSkin& surface, const SkinOptions& skin, const std::vector<glm::vec4>& irradiance);
  void setLevels(const GpuSkin& surface, const PointDiffusion::Levels& levels);
  bool byPoints() const { return finished() && byPoints_; }
  void setDiffused(const std::vector<glm::vec4>& rgba);
  bool holdsReference() const { return reference_; }

  // timing: all but the final pass.
  SkinView::Timing timing() const;
  std::size_t bytes() const;

 private:
  enum Pass { kMaterial, kLightMaps, kVisibility, kIrradiance, kBlur, kThin, kCombine, kDone };
  void run(const GpuSkin& surface);
  // holds: whether the finished maps are of these keys, and spread at least as well as asked for.
  bool holds(const LightKeys& keys, const GpuSkin& surface, const SkinQuality& quality) const;
  // firstIsLeft: whether the final pass adds the first Gaussian.
  bool firstIsLeft() const;
  void fit(const GpuSkin& surface);
  void adopt(const SkinLook& look, const SkinQuality& quality);
  void drawMaterial(const GpuSkin& surface);
  bool changed(std::size_t light) const { return wanted_.lights[light] != done_.lights[light]; }
  void drawLightMaps(const GpuSkin& surface);
  void drawVisibility(const GpuSkin& surface);
  void drawIrradiance(const GpuSkin& surface);
  void spreadPoints(const GpuSkin& surface);
  void finish(const GpuSkin& surface);
  void blurThin(const GpuSkin& surface);
  void combine(const GpuSkin& surface, int part, const gl::Framebuffer& to);

  PassPrograms programs_{"skin/atlas.vert"};
  LightMaps lightMaps_;
  SkinLook look_;
  SkinQuality quality_;
  SkinMaterial skin_;
  SkinTables tables_;
  gl::Texture specularTable_;
  LightKeys wanted_, done_;
  int next_ = kDone, nextLevel_ = 0;
  std::array<gl::GpuTimer, kDone + kLevels> timers_;  // by pass; blurs by level behind them
  bool reference_ = false, byPoints_ = false;
  glm::vec3 firstWeight_{0};
  glm::ivec2 size_{0};
  std::uint64_t surface_ = 0;  // number of the surface that the maps are of
  gl::Framebuffer material_, visibility_, irradiance_, diffused_, through_;
  BlurLevels levels_;
  std::array<gl::Framebuffer, 3> thin_;
  BlockDiffusion points_;  // for finished pictures and atlases that cannot be blurred
};

}  // namespace sonoskin
