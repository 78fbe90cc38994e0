#include "app/views/light_refiner.h"

#include <utility>

#include "core/skin/scatter_profile.h"
#include "render/gl/read_pixels.h"

namespace sonoskin::ui {

void LightRefiner::begin(const SkinView& view, std::shared_ptr<const SkinSurface> surface,
                         const SkinOptions& skin, const Key& light) {
  if (!worker_) worker_ = std::make_unique<Worker>();
  asked_ = light;
  const auto spread = std::make_shared<Spread>();
  spread->light = light;
  worker_->replace({"Refining light",
                    [spread, kept = kept_, surface = std::move(surface), skin,
                     irradiance = gl::readTexels(view.level(0))](const Progress& progress) {
                      spread->levels =
                          diffuseInBlocks(surface, diffusionOf(skin), irradiance, *kept, progress);
                    },
                    [this, spread] { ready_ = std::move(*spread); }});
}

bool LightRefiner::update(SkinView& view, const GpuSkin& gpu,
                          const std::shared_ptr<const SkinSurface>& surface, const SkinOptions& skin,
                          const Key& light, bool rests) {
  if (worker_)
    for (std::string& failure : worker_->poll()) failures_.push_back(std::move(failure));
  if (view.byPoints()) return false;
  if (const std::optional<Spread> ready = std::exchange(ready_, std::nullopt);
      ready && ready->light == light) {
    view.setLevels(gpu, ready->levels);
    asked_.reset();
    return true;
  }
  if (rests && asked_ != light) begin(view, surface, skin, light);
  return false;
}

void LightRefiner::cancel() {
  if (worker_) worker_->cancel();
  asked_.reset();
  ready_.reset();
}

}  // namespace sonoskin::ui
