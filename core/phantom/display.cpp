#include "core/phantom/display.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/phantom/separable_blur.h"

namespace sonoskin {
namespace {

template <class F>
void eachSlab(const SectorGrid& sector, std::vector<float>& values, const Progress& progress, F&& f) {
  const std::size_t slab = sector.row(0, 1);
  parallelFor(
      sector.elevations, [&](std::ptrdiff_t k) { f(values.data() + std::size_t(k) * slab, slab); }, progress);
}

void smooth(const SectorGrid& s, float mm, std::vector<float>& grey, const Progress& progress) {
  constexpr float kFace = 79;  // mm from the apex
  const auto range = gaussTaps(mm / s.rangeStep, Keep::mean);
  const auto lateral = gaussTaps(mm / (kFace * s.lateralStep()), Keep::mean);
  const auto elevation = gaussTaps(mm / (kFace * s.elevationStep()), Keep::mean);
  const auto n = std::size_t(s.ranges);
  eachSlab(s, grey, progress.part(0, 0.6), [&](float* slab, std::size_t) {
    thread_local std::vector<float> scratch;
    for (int j = 0; j < s.laterals; ++j) blurRow(slab + s.row(j, 0), n, range, scratch);
    blurAcross(slab, std::size_t(s.laterals), n, n, lateral, scratch);
  });
  parallelFor(
      s.laterals,
      [&](std::ptrdiff_t j) {
        thread_local std::vector<float> scratch;
        blurAcross(grey.data() + s.row(int(j), 0), std::size_t(s.elevations), s.row(0, 1), n, elevation,
                   scratch);
      },
      progress.part(0.6, 1));
}

}  // namespace

void showEnvelope(const SectorGrid& sector, const DisplayOptions& options, std::vector<float>& envelope,
                  const Progress& progress) {
  const float scale = 20 / options.range, offset = 1 - options.white / options.range;
  eachSlab(sector, envelope, progress.part(0, 0.5), [&](float* v, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n)
      v[n] = std::clamp(scale * std::log10(v[n] + 1e-9f) + offset, 0.f, 1.f);
  });
  if (options.smoothing > 0) smooth(sector, options.smoothing, envelope, progress.part(0.5, 0.8));
  if (options.threshold <= 0 && options.ceiling >= 1) return;
  const float spread = 1 / (options.ceiling - options.threshold);
  eachSlab(sector, envelope, progress.part(0.8, 1), [&](float* v, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) v[n] = std::clamp((v[n] - options.threshold) * spread, 0.f, 1.f);
  });
}

}  // namespace sonoskin
