#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/document/worker.h"
#include "core/base/hash.h"
#include "render/skin/entering_light.h"
#include "render/skin/points_light.h"

namespace sonoskin::ui {

// LightRefiner: spreads the light of a view from point to point while it rests, in the background: right in folds and
// across charts, where the blurs that follow the mouse are not.
class LightRefiner {
 public:
  // update: once a frame while the view's light is complete. Begins where it rests, and puts what is finished into the
  // view.
  //   input    view    its light is complete
  //            light   the fingerprint of surface and look
  //   output   whether the view has better light than before: it is to be drawn again
  bool update(SkinView& view, const GpuSkin& surface, const Key& light, bool rests);
  // cancel: gives up what is under way, for the light moves.
  void cancel();
  // letGo: cancels, and gives back what was kept for the surface, which is shown no more.
  void letGo();
  // status: what runs, for people; failures: of what ran, each told once.
  Worker::Status status() const { return worker_ ? worker_->status() : Worker::Status{}; }
  std::vector<std::string> failures() { return std::exchange(failures_, {}); }

 private:
  struct Spread {
    Key light;
    PointsLight spread;
  };
  void begin(const EnteringLight& entering, const GpuSkin& surface, const Key& light);

  std::shared_ptr<BlockDiffusion> kept_ = std::make_shared<BlockDiffusion>();  // the worker's alone
  std::optional<Key> asked_;
  std::optional<Spread> ready_;
  std::vector<std::string> failures_;
  std::unique_ptr<Worker> worker_;
};

}  // namespace sonoskin::ui
