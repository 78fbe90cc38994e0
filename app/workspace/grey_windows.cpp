#include "app/workspace/grey_windows.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/texts/texts.h"

namespace sonoskin {

GreyWindow automaticWindow(const Volume<float>& volume) {
  constexpr std::size_t kMost = 400000;  // voxels that are looked at, evenly over the volume
  const std::size_t step = std::max<std::size_t>(1, volume.data.size() / kMost);
  std::vector<float> values;
  for (std::size_t i = 0; i < volume.data.size(); i += step) values.push_back(volume.data[i]);
  if (values.empty()) return {};
  const auto at = [&](double share) {
    const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const float low = at(0.01), high = at(0.99);
  return {.level = 0.5f * (low + high), .width = std::max(high - low, 0.02f)};
}

bool isCt(const Scan& scan) {
  constexpr double kAir = -300;  // no other machine's values are that low; as doubtsOf has it
  return scan.modality == "CT" || (scan.modality.empty() && scan.originalMin < kAir);
}

GreyWindow hounsfieldWindow(const Scan& scan, double level, double width) {
  const double range = std::max(scan.originalMax - scan.originalMin, 1e-9);
  const double stored = scan.originalMin >= 0 ? level + 1024 : level;
  return {.level = float((stored - scan.originalMin) / range), .width = float(width / range)};
}

std::string windowText(const Scan& scan, const GreyWindow& window) {
  const double range = scan.originalMax - scan.originalMin;
  const double level = scan.originalMin + double(window.level) * range, width = double(window.width) * range;
  const int digits = range > 20 ? 0 : 2;
  return trf("window {:.{}f}   level {:.{}f}", width, digits, level, digits);
}

}  // namespace sonoskin
