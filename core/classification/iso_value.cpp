#include "core/classification/iso_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kBins = 256;
constexpr double kSamples = 230'000;  // about so many voxels are looked at, evenly spread
constexpr double kShare = 0.38;       // of the way from fluid to tissue

using Histogram = std::array<double, kBins>;

Histogram sampleHistogram(const Volume<float>& volume, const FieldOfView& view) {
  const Geometry& g = volume.geometry;
  const int stride = std::max(1, int(std::cbrt(double(g.voxels()) / kSamples)));
  const int slices = (g.dims.z + stride - 1) / stride;
  std::vector<Histogram> perSlice(std::size_t(slices), Histogram{});
  parallelFor(slices, [&](std::ptrdiff_t slice) {
    const int k = int(slice) * stride;
    for (int j = 0; j < g.dims.y; j += stride)
      for (int i = 0; i < g.dims.x; i += stride)
        if (view.contains(glm::vec3(i, j, k) * glm::vec3(g.spacing)))
          ++perSlice[std::size_t(slice)]
                    [std::size_t(std::clamp(int(volume.at(i, j, k) * kBins), 0, kBins - 1))];
  });
  Histogram sum{};
  for (const Histogram& h : perSlice)
    for (std::size_t b = 0; b < kBins; ++b) sum[b] += h[b];
  return sum;
}

// The means, in bins, of the two classes whose means differ most, weighted by their sizes.
std::array<double, 2> otsuMeans(const Histogram& histogram) {
  double count = 0, sum = 0;
  for (int b = 0; b < kBins; ++b) {
    count += histogram[std::size_t(b)];
    sum += histogram[std::size_t(b)] * b;
  }
  std::array<double, 2> best{0, kBins - 1};
  double bestSpread = -1, below = 0, belowSum = 0;
  for (int b = 0; b < kBins - 1; ++b) {
    below += histogram[std::size_t(b)];
    belowSum += histogram[std::size_t(b)] * b;
    const double above = count - below;
    if (below <= 0 || above <= 0) continue;
    const double low = belowSum / below, high = (sum - belowSum) / above;
    const double spread = below * above * (high - low) * (high - low);
    if (spread <= bestSpread) continue;
    bestSpread = spread;
    best = {low, high};
  }
  return best;
}

}  // namespace

float proposeIsoValue(const Volume<float>& lowPassed, const FieldOfView& view) {
  const auto [fluid, tissue] = otsuMeans(sampleHistogram(lowPassed, view));
  return float(std::clamp((fluid + kShare * (tissue - fluid) + 0.5) / kBins, 0.02, 0.98));
}

}  // namespace sonoskin
