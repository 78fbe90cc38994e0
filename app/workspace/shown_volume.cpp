#include "app/workspace/shown_volume.h"

#include <algorithm>
#include <cmath>

#include "app/workspace/workspace.h"
#include "core/volume/histogram.h"

namespace sonoskin {

std::shared_ptr<const Volume<float>> shownVolume(const Workspace& w) {
  const auto& classified = w.session.results().classified;
  return w.view.volumeLayer == VolumeLayer::classified && classified ? classified : w.session.scan().volume;
}

const std::vector<float>& VolumeHistogram::of(const std::shared_ptr<const Volume<float>>& volume) {
  if (!seen_.see({volume})) return heights_;
  constexpr std::size_t kBars = 256;
  const std::vector<std::uint64_t> counts = histogram(*volume);
  heights_.assign(kBars, 0);
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
    heights_[bin * kBars / counts.size()] += float(counts[bin]);
  for (float& height : heights_) height = std::log1p(height);
  const float most = std::max(*std::ranges::max_element(heights_), 1.0f);
  for (float& height : heights_) height /= most;
  return heights_;
}

}  // namespace sonoskin
