#include "render/gpu_volume.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "render/camera.h"

namespace sonoskin {
namespace {

constexpr int kSlices = 8;  // that are copied at once: they need little memory beside the texture's own

float toUnit(float value) { return std::clamp(value, 0.0f, 1.0f); }

// What a stored number means, 0 to 1.
float meant(float value) { return value; }
float meant(std::uint8_t value) { return float(value) / 255; }

std::uint8_t toByte(float value) { return std::uint8_t(255 * toUnit(value) + 0.5f); }

// Whether every value is a multiple of 1/255, as in a volume that was recorded with 8 bits.
bool fitsBytes(const Volume<float>& volume) {
  std::atomic<bool> fits{true};
  const std::size_t slice = volume.geometry.index(0, 0, 1);
  parallelFor(volume.geometry.dims.z, [&](std::ptrdiff_t k) {
    const float* v = volume.data.data() + std::size_t(k) * slice;
    bool all = fits;
    for (std::size_t i = 0; i < slice && all; ++i)
      all = std::abs(255 * v[i] - std::round(255 * v[i])) < 1e-3f;
    if (!all) fits = false;
  });
  return fits;
}

// Converts and uploads some slices.
template <class To, class From, class F>
void uploadSlices(gl::Texture& texture, const Volume<From>& volume, int first, int count, F&& convert) {
  const std::size_t slice = volume.geometry.index(0, 0, 1);
  std::vector<To> texels(slice * std::size_t(count));
  parallelFor(count, [&](std::ptrdiff_t k) {
    const From* from = &volume.data[(std::size_t(first) + std::size_t(k)) * slice];
    To* to = &texels[std::size_t(k) * slice];
    for (std::size_t i = 0; i < slice; ++i) to[i] = convert(from[i]);
  });
  texture.uploadSlices(first, count, texels.data());
}

// One row of the shade texture: central differences, one-sided at the border.
template <class T>
void shadeRow(const Volume<T>& volume, int j, int k, glm::u8vec4* row) {
  const auto dims = volume.geometry.dims;
  const glm::vec3 scale =
      2.0f * volume.geometry.axisScale();  // times 4, and central differences span two voxels
  const int j0 = std::max(j - 1, 0), j1 = std::min(j + 1, dims.y - 1);
  const int k0 = std::max(k - 1, 0), k1 = std::min(k + 1, dims.z - 1);
  const T *here = &volume.at(0, j, k), *below = &volume.at(0, j0, k), *above = &volume.at(0, j1, k),
          *before = &volume.at(0, j, k0), *behind = &volume.at(0, j, k1);
  const auto between = [](T from, T to) { return meant(to) - meant(from); };
  for (int i = 0; i < dims.x; ++i) {
    const int i0 = std::max(i - 1, 0), i1 = std::min(i + 1, dims.x - 1);
    const glm::vec3 g = scale * glm::vec3(between(here[i0], here[i1]), between(below[i], above[i]),
                                          between(before[i], behind[i]));
    const glm::vec3 c = 127.5f * glm::clamp(g, -1.0f, 1.0f) + 128.0f;  // + 0.5 to round
    row[i] = glm::u8vec4(std::uint8_t(c.x), std::uint8_t(c.y), std::uint8_t(c.z), toByte(meant(here[i])));
  }
}

// The maximum of a brick's voxels, one voxel of overlap at its far sides included.
template <class T>
float brickMaximum(const Volume<T>& volume, const glm::ivec3& first, int side) {
  const glm::ivec3 last = glm::min(first + side, volume.geometry.dims - 1);
  T most = 0;
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j) {
      const T* row = &volume.at(0, j, k);
      for (int i = first.x; i <= last.x; ++i) most = std::max(most, row[i]);
    }
  return meant(most);
}

template <class T>
std::vector<float> maximaOf(const Volume<T>& volume, int side) {
  const glm::ivec3 bricks = (volume.geometry.dims + side - 1) / side;
  std::vector<float> maxima(std::size_t(bricks.x) * std::size_t(bricks.y) * std::size_t(bricks.z));
  parallelFor(bricks.y * bricks.z, [&](std::ptrdiff_t row) {
    for (int b = 0; b < bricks.x; ++b)
      maxima[std::size_t(row) * std::size_t(bricks.x) + std::size_t(b)] =
          brickMaximum(volume, side * glm::ivec3(b, int(row) % bricks.y, int(row) / bricks.y), side);
  });
  return maxima;
}

// Some slices of the shade texture after the other.
template <class T>
gl::Texture shadesOf(const Volume<T>& volume) {
  const Geometry& g = volume.geometry;
  const auto dims = g.dims;
  gl::Texture made({.size = dims, .format = gl::Format::rgba8});
  std::vector<glm::u8vec4> texels(g.index(0, 0, 1) * std::size_t(std::min(kSlices, dims.z)));
  for (int first = 0; first < dims.z; first += kSlices) {
    const int count = std::min(kSlices, dims.z - first);
    parallelFor(std::ptrdiff_t(count) * dims.y, [&](std::ptrdiff_t row) {
      const int j = int(row) % dims.y, k = int(row) / dims.y;
      shadeRow(volume, j, first + k, &texels[g.index(0, j, k)]);
    });
    made.uploadSlices(first, count, texels.data());
  }
  return made;
}

}  // namespace

std::vector<float> brickMaxima(const Volume<float>& volume, int side) { return maximaOf(volume, side); }

// Empty first: two would need twice the memory.
void GpuVolume::begin(const Geometry& geometry) {
  static std::atomic<std::uint64_t> volumes{0};
  *this = GpuVolume();
  number_ = ++volumes;
  geometry_ = geometry;
}

void GpuVolume::set(std::shared_ptr<const Volume<float>> volume) {
  if (volume == floats_ && !bytes_) return;
  begin(volume ? volume->geometry : Geometry{});
  floats_ = std::move(volume);
}

void GpuVolume::set(std::shared_ptr<const Volume<std::uint8_t>> volume) {
  if (volume == bytes_ && !floats_) return;
  begin(volume ? volume->geometry : Geometry{});
  bytes_ = std::move(volume);
}

void GpuVolume::uploadSome() const {
  if (!values_) {
    const bool bytes = bytes_ || fitsBytes(*floats_);
    values_ = gl::Texture({.size = geometry_.dims, .format = bytes ? gl::Format::r8 : gl::Format::r16});
  }
  const int first = uploaded_, count = std::min(kSlices, geometry_.dims.z - first);
  if (bytes_)
    values_.uploadSlices(first, count, &bytes_->data[geometry_.index(0, 0, first)]);
  else if (values_.description().format == gl::Format::r8)
    uploadSlices<std::uint8_t>(values_, *floats_, first, count, toByte);
  else
    uploadSlices<std::uint16_t>(values_, *floats_, first, count,
                                [](float v) { return std::uint16_t(65535 * toUnit(v) + 0.5f); });
  uploaded_ = first + count;
}

const gl::Texture& GpuVolume::values() const {
  while (!empty() && uploaded_ < geometry_.dims.z) uploadSome();
  return values_;
}

bool GpuVolume::prepare(double seconds, bool withBricks) {
  if (empty()) return true;
  const bool valuesFirst = uploaded_ < geometry_.dims.z;
  for (const Timer timer; uploaded_ < geometry_.dims.z;) {
    uploadSome();
    if (timer.seconds() > seconds) break;
  }
  const bool wanted = withBricks && !bricks_;
  if (wanted && !valuesFirst) bricks();  // at once, in a call of their own
  return uploaded_ == geometry_.dims.z && (!wanted || !valuesFirst);
}

const gl::Texture& GpuVolume::bricks() {
  if (bricks_ || empty()) return bricks_;
  maxima_ = floats_ ? maximaOf(*floats_, kBrick) : maximaOf(*bytes_, kBrick);
  gl::Texture made({.size = (geometry_.dims + kBrick - 1) / kBrick,
                    .format = gl::Format::r32f,
                    .filter = gl::Filter::nearest});
  made.upload(maxima_.data());
  return bricks_ = std::move(made);
}

Box GpuVolume::contentBox(float threshold) {
  const glm::ivec3 count = bricks().size(), last = geometry_.dims - 1;
  glm::ivec3 low = last, high(0);
  for (int k = 0, b = 0; k < count.z; ++k)
    for (int j = 0; j < count.y; ++j)
      for (int i = 0; i < count.x; ++i, ++b)
        if (maxima_[std::size_t(b)] > threshold) {
          low = glm::min(low, kBrick * glm::ivec3(i, j, k));
          high = glm::max(high, glm::min(kBrick * (glm::ivec3(i, j, k) + 1), last));
        }
  if (glm::any(glm::greaterThan(low, high))) return worldBox(geometry_);
  Geometry part = geometry_;
  part.origin = geometry_.toWorld(glm::dvec3(low));
  part.dims = high - low + 1;
  return worldBox(part);
}

const gl::Texture& GpuVolume::shades() {
  if (shades_ || empty()) return shades_;
  return shades_ = floats_ ? shadesOf(*floats_) : shadesOf(*bytes_);
}

}  // namespace sonoskin
