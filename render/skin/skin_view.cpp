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

bool SkinView::complete() const { return state_->complete; }

void SkinView::relight(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality) {
  while (!state_->light.shows(surface, look, quality)) {
    state_->light.begin(surface, look, quality);
    state_->light.step(surface);
  }
}

void SkinView::spread(const GpuSkin& surface, const SkinOptions& skin,
                      const std::vector<glm::vec4>& irradiance) {
  state_->light.spread(surface, skin, irradiance);
}

const gl::Texture& SkinView::level(int level) const { return state_->light.level(level); }
const gl::Texture& SkinView::diffused() const { return state_->light.diffused(); }
const gl::Texture& SkinView::albedo() const { return state_->light.albedo(); }
const gl::Texture& SkinView::finish() const { return state_->light.finish(); }
glm::vec3 SkinView::firstWeight() const { return state_->light.firstWeight(); }
void SkinView::setLevels(const GpuSkin& surface, const PointDiffusion::Levels& levels) {
  state_->light.setLevels(surface, levels);
}
bool SkinView::byPoints() const { return state_->light.byPoints(); }
void SkinView::setDiffused(const std::vector<glm::vec4>& rgba) { state_->light.setDiffused(rgba); }
SkinView::Timing SkinView::timing() const {
  Timing timing = state_->light.timing();
  timing.final = 1000 * state_->timer.seconds();
  return timing;
}
std::size_t SkinView::mapBytes() const { return state_->light.bytes() + state_->surfaceBytes; }

}  // namespace sonoskin
