#include "core/volume/gaussian.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// A symmetric kernel: its middle weight, then those at distance 1, 2, ... to both sides.
using HalfKernel = std::vector<float>;

HalfKernel halfOf(const std::vector<float>& kernel) {
  return {kernel.begin() + std::ptrdiff_t(kernel.size() / 2), kernel.end()};
}

// out[x] = sum over m of weight[m] (before[m][x] + after[m][x]), four distances in one stream.
//   rows    rows[0] is the middle; rows[2m-1] and rows[2m] lie at distance m
void weighFour(const float* const* rows, const float* weights, std::size_t distances, bool first, float* out,
               int count) {
  const float w0 = weights[0], w1 = distances > 1 ? weights[1] : 0, w2 = distances > 2 ? weights[2] : 0,
              w3 = distances > 3 ? weights[3] : 0;
  const auto pair = [&](std::size_t m) { return std::min(m, distances - 1); };
  const float *a0 = rows[0], *b0 = rows[1], *a1 = rows[2 * pair(1)], *b1 = rows[2 * pair(1) + 1],
              *a2 = rows[2 * pair(2)], *b2 = rows[2 * pair(2) + 1], *a3 = rows[2 * pair(3)],
              *b3 = rows[2 * pair(3) + 1];
  if (first) {
#pragma omp simd
    for (int x = 0; x < count; ++x)
      out[x] = w0 * (a0[x] + b0[x]) + w1 * (a1[x] + b1[x]) + (w2 * (a2[x] + b2[x]) + w3 * (a3[x] + b3[x]));
  } else {
#pragma omp simd
    for (int x = 0; x < count; ++x)
      out[x] += w0 * (a0[x] + b0[x]) + w1 * (a1[x] + b1[x]) + (w2 * (a2[x] + b2[x]) + w3 * (a3[x] + b3[x]));
  }
}

// convolve: out[x] = sum over m of kernel[|m|] row(m)[x]; row(m) for m in [-radius, radius].
template <class RowAt>
void convolve(const HalfKernel& kernel, const RowAt& row, float* out, int count) {
  std::array<const float*, 8> rows{};
  std::array<float, 4> weights{};
  const std::size_t distances = kernel.size();
  for (std::size_t from = 0; from < distances; from += 4) {
    const std::size_t some = std::min<std::size_t>(4, distances - from);
    for (std::size_t m = 0; m < some; ++m) {
      const int distance = int(from + m);
      rows[2 * m] = row(-distance);
      rows[2 * m + 1] = row(distance);
      weights[m] = distance == 0 ? 0.5f * kernel[0] : kernel[from + m];  // the middle is both its sides
    }
    weighFour(rows.data(), weights.data(), some, from == 0, out, count);
  }
}

// Blurs slices in a slab of k one after the other, keeping those that the kernel along k still needs.
class SlabBlur {
 public:
  SlabBlur(const Volume<float>& volume, const std::array<HalfKernel, 3>& kernels)
      : volume_(volume),
        kernels_(kernels),
        dims_(volume.geometry.dims),
        slice_(volume.geometry.index(0, 0, 1)),
        radius_(int(kernels[2].size()) - 1),
        ring_(std::size_t(2 * radius_ + 1)),
        padded_(std::size_t(dims_.x) + 2 * kernels[0].size()),
        plane_(slice_) {
    for (LargeArray<float>& slice : ring_) slice.resize(slice_);
  }

  // blur: the slices [begin, end) of the result.
  void blur(int begin, int end, Volume<float>& result, const Progress& progress) {
    for (int k = begin - radius_; k < begin + radius_; ++k) inPlane(k);
    for (int k = begin; k < end; ++k) {
      progress.update(double(k - begin) / double(end - begin));
      inPlane(k + radius_);
      convolve(
          kernels_[2], [&](int m) { return ring(k + m); }, &result.at(0, 0, k), int(slice_));
    }
  }

 private:
  float* ring(int k) { return ring_[std::size_t(k + 2 * int(ring_.size())) % ring_.size()].data(); }

  // Slice k, repeated beyond the volume's ends, blurred along i and j, into the ring.
  void inPlane(int k) {
    const int radius = int(kernels_[0].size()) - 1, source = std::clamp(k, 0, dims_.z - 1);
    for (int j = 0; j < dims_.y; ++j) {
      const float* row = &volume_.at(0, j, source);
      std::fill_n(padded_.begin(), radius, row[0]);
      std::copy_n(row, dims_.x, padded_.begin() + radius);
      std::fill_n(padded_.begin() + radius + dims_.x, radius, row[dims_.x - 1]);
      convolve(
          kernels_[0], [&](int m) { return padded_.data() + radius + m; }, planeRow(j), dims_.x);
    }
    float* out = ring(k);
    for (int j = 0; j < dims_.y; ++j)
      convolve(
          kernels_[1], [&](int m) { return planeRow(std::clamp(j + m, 0, dims_.y - 1)); },
          out + std::ptrdiff_t(j) * dims_.x, dims_.x);
  }
  float* planeRow(int j) { return plane_.data() + std::ptrdiff_t(j) * dims_.x; }

  const Volume<float>& volume_;
  const std::array<HalfKernel, 3>& kernels_;
  glm::ivec3 dims_;
  std::size_t slice_;
  int radius_;
  std::vector<LargeArray<float>> ring_;
  std::vector<float> padded_;
  LargeArray<float> plane_;
};

}  // namespace

std::vector<float> gaussianKernel(double sigmaVoxels) {
  if (sigmaVoxels < 0.05) return {1.0f};
  const int radius = int(std::ceil(3 * sigmaVoxels));
  std::vector<float> kernel;
  double sum = 0;
  for (int m = -radius; m <= radius; ++m) sum += std::exp(-0.5 * m * m / (sigmaVoxels * sigmaVoxels));
  for (int m = -radius; m <= radius; ++m)
    kernel.push_back(float(std::exp(-0.5 * m * m / (sigmaVoxels * sigmaVoxels)) / sum));
  return kernel;
}

Volume<float> gaussianBlur(const Volume<float>& volume, double sigma, const Progress& progress) {
  const Geometry& geometry = volume.geometry;
  const glm::vec3 scale = geometry.axisScale();
  std::array<HalfKernel, 3> kernels;
  for (int axis = 0; axis < 3; ++axis)
    kernels[std::size_t(axis)] = halfOf(gaussianKernel(sigma * double(scale[axis])));
  Volume<float> result = Volume<float>::unset(geometry);
  parallelThreads([&](int thread, int threads) {
    const int begin = int(std::int64_t(geometry.dims.z) * thread / threads);
    const int end = int(std::int64_t(geometry.dims.z) * (thread + 1) / threads);
    if (begin < end)
      SlabBlur(volume, kernels).blur(begin, end, result, thread == 0 ? progress : progress.cancelOnly());
  });
  progress.update(1);
  return result;
}

}  // namespace sonoskin
