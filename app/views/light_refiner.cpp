#include "app/views/light_refiner.h"

#include <utility>

#include "render/gl/read_pixels.h"
#include "render/skin/light_passes.h"

namespace sonoskin::ui {

void LightRefiner::begin(const EnteringLight& entering, const GpuSkin& surface, const Key& light) {
  if (!worker_) worker_ = std::make_unique<Worker>();
  asked_ = light;
  const auto spread = std::make_shared<Spread>();
  spread->light = light;
  const auto entered = std::make_shared<EnteredLight>(
      EnteredLight{gl::readTexels(entering.irradiance()), gl::readTexels(entering.thinness())});
  worker_->replace(
      {"Refining light",
       [spread, entered, kept = kept_, surface = surface.surface(), profile = entering.material().diffusion,
        thin = entering.look().skin.thinModel](const Progress& progress) {
         spread->spread = spreadByPoints(surface, profile, thin, std::move(*entered), *kept, progress);
       },
       [this, spread] { ready_ = std::move(*spread); }});
}

bool LightRefiner::update(SkinView& view, const GpuSkin& surface, const Key& light, bool rests) {
  if (worker_)
    for (std::string& failure : worker_->poll()) failures_.push_back(std::move(failure));
  if (view.light().refined()) return false;
  if (const std::optional<Spread> ready = std::exchange(ready_, std::nullopt);
      ready && ready->light == light) {
    view.light().take(surface, ready->spread);
    asked_.reset();
    return true;
  }
  if (rests && asked_ != light) begin(view.light().entering(), surface, light);
  return false;
}

void LightRefiner::cancel() {
  if (worker_) worker_->cancel();
  asked_.reset();
  ready_.reset();
}

void LightRefiner::letGo() {
  cancel();
  kept_ = std::make_shared<BlockDiffusion>();
}

}  // namespace sonoskin::ui
