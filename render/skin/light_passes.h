#pragma once

#include <array>

#include "render/skin/diffuser.h"
#include "render/skin/entering_light.h"
#include "render/skin/light_keys.h"

namespace sonoskin {

// LightPasses: the order of work from lights and material to the light that leaves the skin, one pass at a time; what has
// not changed is kept.
//   EnteringLight's passes -> those of the Diffuser
// None of it depends on the camera. A light that moves leaves the maps and the visibility of the others.
class LightPasses {
 public:
  // begin: what the steps work toward. A look whose passes are under way is finished first, so that light that is
  // dragged about is seen at all.
  void begin(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality);
  // step: runs the next pass; false when nothing was left to do.
  //   progress   of what the CPU spreads
  bool step(const GpuSkin& surface, const Progress& progress = {});
  // giveBack: the memory of what no later pass of this light reads, the surface's maps among it; once the light is finished
  // only its picture can be drawn (FinalPass), and no other light begun.
  void giveBack(GpuSkin& surface);
  // shows: whether the finished light is that of a look, and spread at least as well as asked for.
  bool shows(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) const;

  // lit: whether any look's light has been finished on the surface.
  bool lit() const { return done_ != LightKeys(); }
  // refined: whether light is there that was spread better than by blurs.
  bool refined() const { return finished() && diffuser_.method() > DiffusionMethod::blurs; }
  const EnteringLight& entering() const { return entering_; }
  const Diffuser& diffuser() const { return diffuser_; }
  // drawThrough, drawLevel: make Diffuser::through and Diffuser::level.
  void drawThrough(const GpuSkin& surface) { diffuser_.drawThrough(surface, entering_); }
  void drawLevel(const GpuSkin& surface, int level) { diffuser_.drawLevel(surface, entering_, level); }

  // spread: what becomes of a given irradiance instead of the lights'.
  //   irradiance   atlas size, linear RGB premultiplied by coverage in a
  void spread(const GpuSkin& surface, const SkinOptions& skin, const std::vector<glm::vec4>& irradiance);
  // take: puts light that was spread elsewhere (Diffuser::take) in the place of what is shown and keeps it until the light
  // changes; the last draw must have been complete.
  void take(const GpuSkin& surface, const PointsLight& spread);

  // timing: all but the final pass.
  SkinView::Timing timing() const;
  std::size_t bytes() const { return entering_.bytes() + diffuser_.bytes(); }

 private:
  enum Pass { kMaterial, kLightMaps, kVisibility, kIrradiance, kDiffusion, kDone };
  void run(const GpuSkin& surface, const Progress& progress);
  bool finished() const { return next_ == kDone; }
  bool holds(const LightKeys& keys, const GpuSkin& surface, const SkinQuality& quality) const;
  void fit(const GpuSkin& surface);
  // forEachChanged: calls f(i) for the lights that are not as they were.
  template <class F>
  void forEachChanged(F&& f) const {
    for (std::size_t i = 0; i < LightRig::kMost; ++i)
      if (wanted_.lights[i] != done_.lights[i]) f(i);
  }

  EnteringLight entering_;
  Diffuser diffuser_;
  SkinQuality quality_;
  LightKeys wanted_, done_;
  int next_ = kDone;
  std::array<gl::GpuTimer, kDiffusion> timers_;  // by pass; the diffuser has its own
  std::uint64_t surface_ = 0;                    // number of the surface that the maps are of
};

}  // namespace sonoskin
