#include "core/io/normalise.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>

#include "core/base/parallel.h"
#include "core/io/padding.h"

namespace sonoskin {
namespace {

constexpr double kLowPercentile = 0.0005, kHighPercentile = 0.9995;
constexpr std::size_t kSamples = 1u << 22;
constexpr float kLuminance[3] = {0.2126f, 0.7152f, 0.0722f};

// The values as doubles' nearest floats; not finite ones stay so.
template <class T>
Volume<float> values(const StoredVolume& stored, const std::uint8_t* numbers, const Progress& progress) {
  auto volume = Volume<float>::unset(stored.geometry);
  const std::size_t slice = std::size_t(stored.geometry.dims.x) * std::size_t(stored.geometry.dims.y);
  const std::size_t stride = std::size_t(stored.components);
  const bool colour = stride >= 3;
  parallelFor(
      stored.geometry.dims.z,
      [&](std::ptrdiff_t k) {
        const auto number = [&](std::size_t n) {
          T t;
          std::memcpy(&t, numbers + n * sizeof(T), sizeof(T));
          return double(t);
        };
        for (std::size_t v = std::size_t(k) * slice; v < (std::size_t(k) + 1) * slice; ++v) {
          double value = number(v * stride);
          if (colour)
            value = kLuminance[0] * value + kLuminance[1] * number(v * stride + 1) +
                    kLuminance[2] * number(v * stride + 2);
          volume.data[v] = float(value);
        }
      },
      progress);
  return volume;
}

Volume<float> valuesOf(const StoredVolume& s, const std::uint8_t* n, const Progress& progress) {
  switch (s.type) {
    case NumberType::int8:
      return values<std::int8_t>(s, n, progress);
    case NumberType::uint8:
      return values<std::uint8_t>(s, n, progress);
    case NumberType::int16:
      return values<std::int16_t>(s, n, progress);
    case NumberType::uint16:
      return values<std::uint16_t>(s, n, progress);
    case NumberType::int32:
      return values<std::int32_t>(s, n, progress);
    case NumberType::uint32:
      return values<std::uint32_t>(s, n, progress);
    case NumberType::int64:
      return values<std::int64_t>(s, n, progress);
    case NumberType::uint64:
      return values<std::uint64_t>(s, n, progress);
    case NumberType::float32:
      return values<float>(s, n, progress);
    case NumberType::float64:
      return values<double>(s, n, progress);
  }
  return {};
}

// What the file says is padding is no number from here on. Scales are rounded, and so is what they make of it.
void takeOut(const std::vector<Padding>& padding, Volume<float>& volume) {
  if (padding.empty()) return;
  const std::size_t slice = volume.data.size() / std::size_t(volume.geometry.dims.z);
  parallelFor(volume.geometry.dims.z, [&](std::ptrdiff_t k) {
    const Padding& p = padding[padding.size() == 1 ? 0 : std::size_t(k)];
    const float slack =
        4 * std::numeric_limits<float>::epsilon() * std::max(std::abs(p.least), std::abs(p.most));
    const Padding rounded{p.least - slack, p.most + slack};
    for (std::size_t v = std::size_t(k) * slice; v < (std::size_t(k) + 1) * slice; ++v)
      if (rounded.holds(volume.data[v])) volume.data[v] = std::numeric_limits<float>::quiet_NaN();
  });
}

std::pair<double, double> extremes(const Volume<float>& volume) {
  constexpr float kNone = std::numeric_limits<float>::infinity(), kMost = std::numeric_limits<float>::max();
  const std::size_t slices = std::size_t(volume.geometry.dims.z), slice = volume.data.size() / slices;
  std::vector<std::pair<float, float>> perSlice(slices);
  parallelFor(volume.geometry.dims.z, [&](std::ptrdiff_t k) {
    const float* v = volume.data.data() + std::size_t(k) * slice;
    float low = kNone, high = -kNone;
#pragma omp simd reduction(min : low) reduction(max : high)
    for (std::size_t i = 0; i < slice; ++i) {
      const bool finite = std::abs(v[i]) <= kMost;
      low = std::min(low, finite ? v[i] : kNone);
      high = std::max(high, finite ? v[i] : -kNone);
    }
    perSlice[std::size_t(k)] = {low, high};
  });
  float low = kNone, high = -kNone;
  for (const auto& [least, most] : perSlice) low = std::min(low, least), high = std::max(high, most);
  return low <= high ? std::pair<double, double>(low, high) : std::pair<double, double>(0, 0);
}

// Values within the range become 0 to 1; padding and what is not finite becomes 0.
void scale(float* values, std::size_t count, const NormalisedVolume& n,
           const std::optional<Padding>& padding) {
  constexpr float kMost = std::numeric_limits<float>::max();
  const Padding outside = padding.value_or(Padding{1, 0});  // holds nothing
  const double from = n.originalMin, width = n.originalMax - n.originalMin;
#pragma omp simd
  for (std::size_t v = 0; v < count; ++v) {
    const float value = values[v];
    const bool recorded = (std::abs(value) <= kMost) & !((value >= outside.least) & (value <= outside.most));
    const auto part = float(std::min(std::max((double(value) - from) / width, 0.0), 1.0));
    values[v] = recorded ? part : 0;
  }
}

// Of what was recorded.
std::pair<double, double> percentiles(std::span<const float> data, const std::optional<Padding>& padding) {
  // An odd stride does not fall into step with rows of even length.
  const std::size_t stride = (data.size() / kSamples) | 1;
  std::vector<float> sample;
  sample.reserve(data.size() / stride + 1);
  for (std::size_t v = 0; v < data.size(); v += stride)
    if (std::isfinite(data[v]) && !(padding && padding->holds(data[v]))) sample.push_back(data[v]);
  if (sample.empty()) return {0, 0};
  const auto at = [&](double p) {
    const auto nth = sample.begin() + std::ptrdiff_t(std::lround(p * double(sample.size() - 1)));
    std::nth_element(sample.begin(), nth, sample.end());
    return double(*nth);
  };
  return {at(kLowPercentile), at(kHighPercentile)};
}

// 0 to the least of 1, 255 and 65535 that holds the values and of which they use half: so the same scan is the same
// whatever type it was stored in. Else the values' own range.
std::pair<double, double> naturalRange(const std::pair<double, double>& values) {
  for (const double most : {1.0, 255.0, 65535.0})
    if (values.first >= 0 && values.second <= most && values.second > most / 2) return {0, most};
  return values;
}

// Padding that lies just below the rest is what black was recorded as.
double darkest(const std::pair<double, double>& range, const std::optional<Padding>& padding) {
  constexpr double kJustBelow = 0.05;  // of the range
  const double below = padding ? range.first - double(padding->least) : -1;
  return below > 0 && below < kJustBelow * (range.second - range.first) && range.first != 0
             ? double(padding->least)
             : range.first;
}

std::pair<double, double> unitRange(const StoredVolume& stored, const NormalisedVolume& n,
                                    const std::optional<Padding>& padding) {
  std::pair<double, double> range;
  if (stored.unitRange)
    range = *stored.unitRange;
  else if (stored.type == NumberType::uint8 || stored.type == NumberType::int8) {
    const double least = stored.type == NumberType::uint8 ? 0 : -128;
    range = {least, least + 255};
  } else {
    range = naturalRange(percentiles(n.volume.data, padding));
    range.first = darkest(range, padding || stored.padding.empty() ? padding : stored.padding.front());
    if (!(range.first < range.second)) range = {n.valueMin, n.valueMax};
  }
  return range;
}

// A range that can be divided by, whatever a constant volume or a header holds.
std::pair<double, double> withWidth(const std::pair<double, double>& range) {
  const double width = range.second - range.first;
  if (width > 0 && std::isfinite(width)) return range;
  const double from = std::isfinite(range.first) ? range.first : 0;
  return {from, from + std::max(1.0, std::abs(from))};
}

}  // namespace

NormalisedVolume normalise(const StoredVolume& stored, const std::vector<std::uint8_t>& numbers,
                           const Progress& progress, bool outside) {
  NormalisedVolume n;
  n.volume = valuesOf(stored, numbers.data(), progress.part(0, 0.5));
  takeOut(stored.padding, n.volume);
  std::tie(n.valueMin, n.valueMax) = extremes(n.volume);
  const std::optional<Padding> padding = outside ? findPadding(n.volume) : std::nullopt;
  std::tie(n.originalMin, n.originalMax) = withWidth(unitRange(stored, n, padding));
  const std::size_t slice = n.volume.data.size() / std::size_t(stored.geometry.dims.z);
  parallelFor(
      stored.geometry.dims.z,
      [&](std::ptrdiff_t k) { scale(n.volume.data.data() + std::size_t(k) * slice, slice, n, padding); },
      progress.part(0.5, 1));
  return n;
}

}  // namespace sonoskin
