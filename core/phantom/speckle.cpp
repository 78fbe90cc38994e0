#include "core/phantom/speckle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/phantom/random_field.h"
#include "core/phantom/separable_blur.h"

namespace sonoskin {
namespace {

constexpr float kGainOverDepth = 8;     // dB over the whole range
constexpr float kReceiveFilter = 0.6f;  // samples: the display's smoothing along the beam

float amplitudeOf(float decibel) { return std::pow(10.f, decibel / 20); }

// Streams of random numbers: real and imaginary part of scatterers and of the receiver's noise.
enum Stream : std::uint32_t { kScatterRe = 10, kScatterIm, kNoiseRe, kNoiseIm };

// SlabTaps: the point spread function within one elevation.
struct SlabTaps {
  std::vector<float> range, lateral;
};

// fillSlab: scatterers of one elevation, smeared along range and lateral angle. In: amplitudes in re.
void fillSlab(const SectorGrid& s, int k, int seed, const SlabTaps& taps, float* re, float* im) {
  thread_local std::vector<float> scratch;
  const std::size_t count = s.row(0, 1);
  const auto first = std::uint32_t(s.row(0, k));
  const std::uint32_t keyRe = streamKey(seed, kScatterRe), keyIm = streamKey(seed, kScatterIm);
  for (std::size_t n = 0; n < count; ++n) {
    const float rms = re[n] * 0.70710678f;
    const std::uint32_t index = first + std::uint32_t(n);
    im[n] = rms * normalAt(index, keyIm);
    re[n] = rms * normalAt(index, keyRe);
  }
  for (float* part : {re, im}) {
    for (int j = 0; j < s.laterals; ++j)
      blurRow(part + s.row(j, 0), std::size_t(s.ranges), taps.range, scratch);
    blurAcross(part, std::size_t(s.laterals), std::size_t(s.ranges), std::size_t(s.ranges), taps.lateral,
               scratch);
  }
}

// detect: noise and envelope of one beam; the envelope replaces the real part.
void detect(const SectorGrid& s, std::size_t row, float noise, int seed, float* re, const float* im) {
  const std::uint32_t keyRe = streamKey(seed, kNoiseRe), keyIm = streamKey(seed, kNoiseIm);
  const float gain = std::pow(amplitudeOf(kGainOverDepth), 1 / float(s.ranges));
  float level = noise * 0.70710678f;
  for (int i = 0; i < s.ranges; ++i, level *= gain) {
    const std::uint32_t index = std::uint32_t(row) + std::uint32_t(i);
    const float x = re[i] + level * normalAt(index, keyRe), y = im[i] + level * normalAt(index, keyIm);
    re[i] = std::sqrt(x * x + y * y);
  }
}

// Coarse: a sector averaged over bricks of samples.
struct Coarse {
  SectorGrid grid;
  std::vector<float> values;
};
constexpr int kBrick = 4, kBrickElevation = 2;

Coarse meanPower(const SectorGrid& s, const std::vector<float>& amplitude, const Progress& progress) {
  Coarse c{s, {}};
  c.grid.ranges = (s.ranges + kBrick - 1) / kBrick;
  c.grid.laterals = (s.laterals + kBrick - 1) / kBrick;
  c.grid.elevations = (s.elevations + kBrickElevation - 1) / kBrickElevation;
  c.values.assign(c.grid.samples(), 0.f);
  parallelFor(
      c.grid.elevations,
      [&](std::ptrdiff_t brick) {
        const int end = std::min(s.elevations, int(brick + 1) * kBrickElevation);
        for (int k = int(brick) * kBrickElevation; k < end; ++k)
          for (int j = 0; j < s.laterals; ++j) {
            float* out = c.values.data() + c.grid.row(j / kBrick, int(brick));
            const float* in = amplitude.data() + s.row(j, k);
            for (int i = 0; i < s.ranges; ++i) out[i / kBrick] += in[i] * in[i];
          }
      },
      progress);
  for (float& v : c.values) v *= 1.f / (kBrick * kBrick * kBrickElevation);
  return c;
}

void smear(Coarse& c, const SectorGrid& s, float reach) {
  const float degrees3 = glm::radians(3.f) * reach;
  const auto range = gaussTaps(1.2f * reach / (s.rangeStep * kBrick), Keep::mean);
  const auto lateral = gaussTaps(degrees3 / (s.lateralStep() * kBrick), Keep::mean);
  const auto elevation = gaussTaps(degrees3 / (s.elevationStep() * kBrickElevation), Keep::mean);
  const auto n = std::size_t(c.grid.ranges);
  std::vector<float> scratch;
  for (std::size_t r = 0; r < c.values.size(); r += n) blurRow(c.values.data() + r, n, range, scratch);
  for (int k = 0; k < c.grid.elevations; ++k)
    blurAcross(c.values.data() + c.grid.row(0, k), std::size_t(c.grid.laterals), n, n, lateral, scratch);
  const std::size_t plane = c.grid.row(0, 1);
  blurAcross(c.values.data(), std::size_t(c.grid.elevations), plane, plane, elevation, scratch);
}

}  // namespace

void addClutter(const SectorGrid& s, std::vector<float>& amplitude, const NoiseLevels& noise,
                const Progress& progress) {
  Coarse c = meanPower(s, amplitude, progress.part(0, 0.4));
  smear(c, s, noise.reach);
  const float share = amplitudeOf(2 * noise.clutter);
  parallelFor(
      s.elevations,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < s.laterals; ++j) {
          const float* near = c.values.data() + c.grid.row(j / kBrick, int(k) / kBrickElevation);
          float* a = amplitude.data() + s.row(j, int(k));
          for (int i = 0; i < s.ranges; ++i) a[i] = std::sqrt(a[i] * a[i] + share * near[i / kBrick]);
        }
      },
      progress.part(0.4, 1));
}

std::vector<float> speckleEnvelope(const SectorGrid& s, std::vector<float> amplitude,
                                   const PointSpread& spread, const NoiseLevels& noise, int seed,
                                   const Progress& progress) {
  addClutter(s, amplitude, noise, progress.part(0, 0.2));
  std::vector<float> re = std::move(amplitude), im(s.samples());
  const SlabTaps taps{gaussTaps(spread.range / s.rangeStep, Keep::power),
                      gaussTaps(spread.lateral / s.lateralStep(), Keep::power)};
  const auto alongElevation = gaussTaps(spread.elevation / s.elevationStep(), Keep::power);
  parallelFor(
      s.elevations,
      [&](std::ptrdiff_t k) {
        const std::size_t slab = s.row(0, int(k));
        fillSlab(s, int(k), seed, taps, re.data() + slab, im.data() + slab);
      },
      progress.part(0.2, 0.7));
  const auto smoothing = gaussTaps(kReceiveFilter, Keep::mean);
  const auto ranges = std::size_t(s.ranges), elevations = std::size_t(s.elevations), plane = s.row(0, 1);
  parallelFor(
      s.laterals,
      [&](std::ptrdiff_t j) {
        thread_local std::vector<float> scratch;
        for (auto* part : {&re, &im})
          blurAcross(part->data() + s.row(int(j), 0), elevations, plane, ranges, alongElevation, scratch);
        for (int k = 0; k < s.elevations; ++k) {
          const std::size_t row = s.row(int(j), k);
          detect(s, row, amplitudeOf(noise.receiver), seed, re.data() + row, im.data() + row);
          blurRow(re.data() + row, ranges, smoothing, scratch);
        }
      },
      progress.part(0.7, 1));
  return re;
}

}  // namespace sonoskin
