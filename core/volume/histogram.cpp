#include "core/volume/histogram.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kBins = 1024;
using Counts = std::array<std::uint32_t, kBins>;

}  // namespace

double quantile(const Volume<float>& volume, double share, const Progress& progress) {
  const std::size_t slice = volume.geometry.index(0, 0, 1);
  std::vector<Counts> perSlice(std::size_t(volume.geometry.dims.z), Counts{});
  parallelFor(
      volume.geometry.dims.z,
      [&](std::ptrdiff_t k) {
        Counts& counts = perSlice[std::size_t(k)];
        const float* v = volume.data.data() + std::size_t(k) * slice;
        for (std::size_t i = 0; i < slice; ++i)
          ++counts[std::size_t(std::clamp(v[i] * kBins, 0.0f, kBins - 1.0f))];
      },
      progress);
  const double wanted = share * double(volume.data.size());
  double below = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    for (const Counts& counts : perSlice) below += counts[bin];
    if (below >= wanted) return double(bin + 1) / kBins;
  }
  return 1;
}

}  // namespace sonoskin
