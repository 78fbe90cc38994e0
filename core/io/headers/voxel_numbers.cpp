#include "core/io/headers/voxel_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/headers/number_types.h"
#include "core/io/headers/voxel_parts.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uintmax_t kMaxNumbers = std::uintmax_t(1) << 33;

void toThisOrder(const DeclaredData& data, Bytes& bytes) {
  const std::size_t size = numberTypeBytes(data.type);
  const bool here = data.bigEndian == (std::endian::native == std::endian::big);
  if (here || size == 1 || data.encoding == Encoding::text) return;
  for (std::size_t b = 0; b + size <= bytes.size(); b += size)
    std::reverse(bytes.begin() + std::ptrdiff_t(b), bytes.begin() + std::ptrdiff_t(b + size));
}

// How far apart neighbours along each axis lie, in numbers.
std::vector<std::size_t> stridesOf(const DeclaredData& data) {
  std::vector<std::size_t> strides;
  std::size_t stride = data.componentAxis < 0 ? std::size_t(data.stored.components) : 1;
  for (const std::int64_t size : data.sizes) {
    strides.push_back(stride);
    stride *= std::size_t(size);
  }
  return strides;
}

// Axis: a way through the numbers.
struct Axis {
  std::size_t size = 1, stride = 1;
};

// The axes of the answer, fastest first: colour, i, j, k.
std::array<Axis, 4> wantedAxes(const DeclaredData& data) {
  const std::vector<std::size_t> strides = stridesOf(data);
  std::array<Axis, 4> axes;
  axes[0].size = std::size_t(data.stored.components);
  if (data.componentAxis >= 0) axes[0].stride = strides[std::size_t(data.componentAxis)];
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t n = std::size_t(data.spaceAxes[a]);
    axes[a + 1] = {std::size_t(data.sizes[n]), strides[n]};
  }
  return axes;
}

Bytes gathered(const Bytes& from, std::size_t first, const std::array<Axis, 4>& axes, std::size_t size) {
  const std::size_t row = axes[0].size * axes[1].size * size;
  Bytes to(row * axes[2].size * axes[3].size);
  parallelFor(std::ptrdiff_t(axes[3].size), [&](std::ptrdiff_t k) {
    std::uint8_t* out = to.data() + std::size_t(k) * axes[2].size * row;
    for (std::size_t j = 0; j < axes[2].size; ++j)
      for (std::size_t i = 0; i < axes[1].size; ++i)
        for (std::size_t c = 0; c < axes[0].size; ++c, out += size) {
          const std::size_t at = first + std::size_t(k) * axes[3].stride + j * axes[2].stride +
                                 i * axes[1].stride + c * axes[0].stride;
          std::memcpy(out, from.data() + at * size, size);
        }
  });
  return to;
}

bool inOrder(const std::array<Axis, 4>& axes) {
  std::size_t stride = 1;
  for (const Axis& axis : axes) {
    if (axis.size > 1 && axis.stride != stride) return false;
    stride *= axis.size;
  }
  return true;
}

template <class To>
Bytes scaled(const Bytes& bytes, const DeclaredData& data) {
  return visitNumber(data.type, [&](auto number) {
    using From = decltype(number);
    Bytes out(bytes.size() / sizeof(From) * sizeof(To));
    for (std::size_t n = 0; n < bytes.size() / sizeof(From); ++n) {
      From from;
      std::memcpy(&from, bytes.data() + n * sizeof(From), sizeof(From));
      const To to = To(data.slope * double(from) + data.intercept);
      std::memcpy(out.data() + n * sizeof(To), &to, sizeof(To));
    }
    return out;
  });
}

}  // namespace

std::uint64_t numbersIn(const DeclaredData& data, const fs::path& path) {
  std::uintmax_t numbers = data.componentAxis < 0 ? std::uintmax_t(data.stored.components) : 1;
  for (const std::int64_t size : data.sizes) {
    require(size >= 1 && size <= 65535,
            "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(), size);
    numbers *= std::uintmax_t(size);
    require(numbers <= kMaxNumbers,
            "{} says that it has at least {} voxels, more than fit into memory; crop it first.",
            path.string(), numbers);
  }
  return numbers;
}

void setScale(DeclaredData& data, double slope, double intercept) {
  if (std::isfinite(slope) && slope != 0) data.slope = slope;
  if (std::isfinite(intercept)) data.intercept = intercept;
  if (data.slope != 1 || data.intercept != 0)
    data.stored.type = data.type == NumberType::float64 ? NumberType::float64 : NumberType::float32;
}

Bytes readNumbers(const DeclaredData& data, const fs::path& path, int step, const Progress& progress) {
  const std::size_t size = numberTypeBytes(data.type);
  const std::uintmax_t all = numbersIn(data, path) * size;
  const std::array<Axis, 4> axes = wantedAxes(data);
  const std::size_t first =
      data.timeAxis < 0 ? 0 : std::size_t(step) * stridesOf(data)[std::size_t(data.timeAxis)];
  // Where the wanted numbers are in order they lie one after another, and nothing else has to be kept.
  const bool plain = inOrder(axes);
  const std::uintmax_t wanted = std::accumulate(axes.begin(), axes.end(), size,
                                                [](std::size_t n, const Axis& a) { return n * a.size; });
  const Stretch range = plain ? Stretch{first * size, first * size + wanted} : Stretch{0, all};
  Bytes bytes = readStretch(data, range, all, path, progress);
  toThisOrder(data, bytes);
  if (!plain) bytes = gathered(bytes, first, axes, size);
  if (data.slope == 1 && data.intercept == 0) return bytes;
  return data.stored.type == NumberType::float64 ? scaled<double>(bytes, data) : scaled<float>(bytes, data);
}

}  // namespace sonoskin
