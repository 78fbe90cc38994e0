#include "render/skin/skin_view.h"

#include "render/skin/final_pass.h"
#include "render/skin/gpu_skin.h"
#include "render/skin/light_passes.h"

namespace sonoskin {

struct SkinView::State {
  LightPasses light;
  FinalPass final;
  gl::GpuTimer timer;
  std::size_t surfaceBytes = 0;
  bool complete = false;
};

SkinView::SkinView() : state_(std::make_unique<State>()) {}
SkinView::~SkinView() = default;
SkinView::SkinView(SkinView&&) noexcept = default;
SkinView& SkinView::operator=(SkinView&&) noexcept = default;

void SkinView::draw(const SkinViewInput& input, const gl::Target& target) {
  State& s = *state_;
  s.surfaceBytes = input.surface.parts().bytes();
  for (int left = input.steps; left > 0; --left) {
    s.light.begin(input.surface, input.look, input.quality);
    if (!s.light.step(input.surface)) break;
  }
  s.complete = s.light.shows(input.surface, input.look, input.quality);
  s.timer.begin();
  s.final.draw(input, s.light, target);
  s.timer.end();
}

LightState SkinView::state() const {
  if (!state_->light.lit()) return LightState::none;
  if (!state_->complete) return LightState::earlier;
  return state_->light.refined() ? LightState::refined : LightState::complete;
}

void SkinView::relight(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality,
                       const Progress& progress) {
  while (!state_->light.shows(surface, look, quality)) {
    state_->light.begin(surface, look, quality);
    state_->light.step(surface, progress);
  }
}

void SkinView::relightOnce(GpuSkin& surface, const SkinLook& look, const SkinQuality& quality,
                           const Progress& progress) {
  while (!state_->light.shows(surface, look, quality)) {
    state_->light.begin(surface, look, quality);
    state_->light.step(surface, progress);
    state_->light.giveBack(surface);
  }
}

LightPasses& SkinView::light() { return state_->light; }
const LightPasses& SkinView::light() const { return state_->light; }

SkinView::Timing SkinView::timing() const {
  Timing timing = state_->light.timing();
  timing.final = 1000 * state_->timer.seconds();
  return timing;
}
std::size_t SkinView::mapBytes() const { return state_->light.bytes() + state_->surfaceBytes; }

}  // namespace sonoskin
