#include "core/volume/histogram.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kBins = 1024;
constexpr std::size_t kLanes = 4;
using Counts = std::array<std::uint32_t, kBins>;

std::size_t binOf(float value) { return std::size_t(int(std::clamp(value * kBins, 0.0f, kBins - 1.0f))); }

}  // namespace

std::vector<std::uint64_t> histogram(const Volume<float>& volume, const Progress& progress) {
  const std::size_t slice = volume.geometry.index(0, 0, 1);
  std::vector<Counts> perSlice(std::size_t(volume.geometry.dims.z), Counts{});
  parallelFor(
      volume.geometry.dims.z,
      [&](std::ptrdiff_t k) {
        // Neighbours often fall into the same bin: counting them in turn in several histograms keeps a count from
        // waiting for the one before.
        std::array<Counts, kLanes> lanes{};
        const float* v = volume.data.data() + std::size_t(k) * slice;
        std::size_t i = 0;
        for (; i + kLanes <= slice; i += kLanes)
          for (std::size_t lane = 0; lane < kLanes; ++lane) ++lanes[lane][binOf(v[i + lane])];
        for (; i < slice; ++i) ++lanes[0][binOf(v[i])];
        for (const Counts& lane : lanes)
          for (std::size_t bin = 0; bin < kBins; ++bin) perSlice[std::size_t(k)][bin] += lane[bin];
      },
      progress);
  std::vector<std::uint64_t> sum(kBins);
  for (const Counts& counts : perSlice)
    for (std::size_t bin = 0; bin < kBins; ++bin) sum[bin] += counts[bin];
  return sum;
}

double quantile(const Volume<float>& volume, double share, const Progress& progress) {
  const std::vector<std::uint64_t> counts = histogram(volume, progress);
  const double wanted = share * double(volume.data.size());
  double below = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    below += double(counts[bin]);
    if (below >= wanted) return double(bin + 1) / kBins;
  }
  return 1;
}

}  // namespace sonoskin
