#include "core/io/dicom/dicom_straighten.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

template <class T>
double numberAt(const std::uint8_t* numbers, std::size_t n) {
  T value;
  std::memcpy(&value, numbers + n * sizeof(T), sizeof(T));
  return double(value);
}

double numberAt(NumberType type, const std::uint8_t* numbers, std::size_t n) {
  switch (type) {
    case NumberType::int8:
      return numberAt<std::int8_t>(numbers, n);
    case NumberType::uint8:
      return numberAt<std::uint8_t>(numbers, n);
    case NumberType::int16:
      return numberAt<std::int16_t>(numbers, n);
    case NumberType::uint16:
      return numberAt<std::uint16_t>(numbers, n);
    case NumberType::int32:
      return numberAt<std::int32_t>(numbers, n);
    case NumberType::uint32:
      return numberAt<std::uint32_t>(numbers, n);
    case NumberType::float64:
      return numberAt<double>(numbers, n);
    default:
      return numberAt<float>(numbers, n);
  }
}

// A place along one axis: the pixel below, and the weight of the one above.
struct Place {
  int low = 0;
  double high = 0;
  bool inside = false;
};

Place placeAt(double at, int count) {
  constexpr double kRounding = 1e-6;
  Place place;
  at = std::abs(at - std::round(at)) < kRounding ? std::round(at) : at;
  place.inside = at >= 0 && at <= count - 1;
  if (!place.inside) return place;
  place.low = std::min(int(at), std::max(0, count - 2));
  place.high = at - place.low;
  return place;
}

// What slices hold where the straight grid wants it.
class Slices {
 public:
  explicit Slices(const LoadedVolume& loaded) : loaded_(loaded) {}

  float at(const Place& x, const Place& y, int k, int component) const {
    if (!x.inside || !y.inside) return kNone;
    double sum = 0;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const double weight = (i ? x.high : 1 - x.high) * (j ? y.high : 1 - y.high);
        if (weight == 0) continue;
        const double number = value(x.low + i, y.low + j, k, component);
        if (isPadding(number, k)) return kNone;
        sum += weight * number;
      }
    return float(sum);
  }

 private:
  double value(int i, int j, int k, int component) const {
    const std::size_t voxel = loaded_.stored.geometry.index(i, j, k);
    const std::size_t n = voxel * std::size_t(loaded_.stored.components) + std::size_t(component);
    return numberAt(loaded_.stored.type, loaded_.numbers.data(), n);
  }
  bool isPadding(double number, int k) const {
    const auto& padding = loaded_.stored.padding;
    return !padding.empty() && padding[padding.size() == 1 ? 0 : std::size_t(k)].holds(float(number));
  }

  const LoadedVolume& loaded_;
};

// What 0 and 1 mean, where the type that is given up told.
std::optional<std::pair<double, double>> rangeOf(const StoredVolume& stored) {
  if (stored.type == NumberType::uint8) return std::pair(0.0, 255.0);
  if (stored.type == NumberType::int8) return std::pair(-128.0, 127.0);
  return stored.unitRange;
}

}  // namespace

glm::ivec3 straightened(const Geometry& g, const glm::dvec2& shift) {
  const glm::dvec2 all = glm::abs(shift) * double(g.dims.z - 1) / glm::dvec2(g.spacing);
  return g.dims + glm::ivec3(std::min(std::ceil(all.x - 1e-6), 65535.0),
                             std::min(std::ceil(all.y - 1e-6), 65535.0), 0);
}

void straighten(LoadedVolume& loaded, const glm::dvec2& shift, const Progress& progress) {
  const Geometry from = loaded.stored.geometry;
  Geometry to = from;
  to.dims = straightened(from, shift);
  // Slices that go back along an axis begin at its far end.
  const glm::dvec2 before = glm::min(shift, 0.0) * double(from.dims.z - 1);
  to.origin += from.direction[0] * before.x + from.direction[1] * before.y;
  const int components = loaded.stored.components;
  const Slices slices(loaded);
  std::vector<std::uint8_t> numbers(to.voxels() * std::size_t(components) * sizeof(float));
  parallelFor(
      to.dims.z,
      [&](std::ptrdiff_t k) {
        const glm::dvec2 start = (before - double(k) * shift) / glm::dvec2(from.spacing);
        for (int j = 0; j < to.dims.y; ++j)
          for (int i = 0; i < to.dims.x; ++i) {
            const Place x = placeAt(i + start.x, from.dims.x), y = placeAt(j + start.y, from.dims.y);
            for (int c = 0; c < components; ++c) {
              const float value = slices.at(x, y, int(k), c);
              const std::size_t n = to.index(i, j, int(k)) * std::size_t(components) + std::size_t(c);
              std::memcpy(numbers.data() + n * sizeof(float), &value, sizeof value);
            }
          }
      },
      progress);
  loaded.stored.unitRange = rangeOf(loaded.stored);
  loaded.stored.type = NumberType::float32;
  loaded.stored.geometry = to;
  loaded.stored.padding.clear();
  loaded.numbers = std::move(numbers);
}

}  // namespace sonoskin
