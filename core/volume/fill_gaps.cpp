#include "core/volume/fill_gaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// Combines each voxel with those up to `radius` from it along an axis; row by row, so that the compiler makes
// vectors of it.
//   outside  what lies beyond the volume
//   combine  (out, in, tap), of which 2 radius + 1 come
template <class T, class Combine>
void alongAxis(Volume<T>& volume, int axis, int radius, const T& outside, const Combine& combine) {
  const glm::ivec3 d = volume.geometry.dims;
  const std::size_t row = std::size_t(d.x), plane = row * std::size_t(d.y);
  const std::size_t length = row, count = axis == 0 ? 1 : std::size_t(d[axis]),
                    taps = 2 * std::size_t(radius) + 1;
  const std::size_t stride = axis == 2 ? plane : row;  // from row to row of a bundle
  const std::size_t step = axis == 0 ? 1 : length;     // from tap to tap
  const std::size_t perPlane = axis == 0 ? std::size_t(d.y) : 1;
  parallelFor(axis == 2 ? d.y : d.z, [&](std::ptrdiff_t b) {
    std::vector<T> in((count - 1) * length + length + 2 * std::size_t(radius) * step, outside);
    for (std::size_t m = 0; m < perPlane; ++m) {
      T* const first =
          volume.data.data() + (axis == 2 ? std::size_t(b) * row : std::size_t(b) * plane + m * row);
      for (std::size_t n = 0; n < count; ++n)
        std::copy_n(first + n * stride, length, in.data() + std::size_t(radius) * step + n * length);
      for (std::size_t n = 0; n < count; ++n) {
        T* const out = first + n * stride;
        for (std::size_t t = 0; t < taps; ++t) {
          const T* const from = in.data() + n * length + t * step;
          for (std::size_t i = 0; i < length; ++i)
            out[i] = t == 0 ? combine(T{}, from[i], t) : combine(out[i], from[i], t);
        }
      }
    }
  });
}

// Grows what is set by `radius`, or what is not, which lies beyond the volume too.
void grow(Volume<std::uint8_t>& mask, int radius, bool set) {
  using Byte = std::uint8_t;
  for (int axis = 0; axis < 3; ++axis) {
    if (set)
      alongAxis(mask, axis, radius, Byte(0), [](Byte out, Byte in, std::size_t) { return Byte(out | in); });
    else
      alongAxis(mask, axis, radius, Byte(0),
                [](Byte out, Byte in, std::size_t t) { return t == 0 ? in : Byte(out & in); });
  }
}

// The closing of the mask by a cube, with room around it in which it can grow.
Volume<std::uint8_t> closingOf(const Volume<std::uint8_t>& mask, int radius) {
  const glm::ivec3 d = mask.geometry.dims;
  Geometry wide = mask.geometry;
  wide.dims += 2 * radius;
  Volume<std::uint8_t> room(wide), closed = mask;
  const auto forRows = [&](const auto& visit) {
    for (int k = 0; k < d.z; ++k)
      for (int j = 0; j < d.y; ++j) visit(j, k, &room.at(radius, j + radius, k + radius));
  };
  forRows([&](int j, int k, std::uint8_t* row) { std::copy_n(&mask.at(0, j, k), d.x, row); });
  grow(room, radius, true);
  grow(room, radius, false);
  forRows([&](int j, int k, std::uint8_t* row) { std::copy_n(row, d.x, &closed.at(0, j, k)); });
  return closed;
}

std::vector<float> gaussian(int radius) {
  std::vector<float> kernel;
  const double sigma = std::max(0.5, radius / 2.0);
  for (int n = -radius; n <= radius; ++n) kernel.push_back(float(std::exp(-0.5 * n * n / (sigma * sigma))));
  return kernel;
}

void blur(Volume<float>& volume, const std::vector<float>& kernel) {
  for (int axis = 0; axis < 3; ++axis)
    alongAxis(volume, axis, int(kernel.size() / 2), 0.f,
              [&](float out, float in, std::size_t t) { return out + kernel[t] * in; });
}

}  // namespace

void fillGaps(int radius, Volume<float>& volume, Volume<std::uint8_t>& mask, const Progress& progress) {
  const Volume<std::uint8_t> closed = closingOf(mask, radius);
  progress.update(0.4);
  Volume<float> values = volume, weights = Volume<float>::unset(volume.geometry);
  for (std::size_t v = 0; v < weights.data.size(); ++v) weights.data[v] = mask.data[v] ? 1.f : 0.f;
  const std::vector<float> kernel = gaussian(radius);
  blur(values, kernel);
  progress.update(0.7);
  blur(weights, kernel);
  for (std::size_t v = 0; v < weights.data.size(); ++v) {
    if (mask.data[v] || !closed.data[v] || !(weights.data[v] > 0)) continue;
    volume.data[v] = values.data[v] / weights.data[v];
    mask.data[v] = 255;
  }
}

}  // namespace sonoskin
