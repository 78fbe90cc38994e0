#include "core/volume/gaussian.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// out[x] = sum of weight[m] * rows[m][x]
void weightedSum(const std::vector<const float*>& rows, const std::vector<float>& weights, float* out,
                 int count) {
  std::fill_n(out, count, 0.0f);
  for (std::size_t m = 0; m < rows.size(); ++m) {
    const float* row = rows[m];
    const float weight = weights[m];
#pragma omp simd
    for (int x = 0; x < count; ++x) out[x] += weight * row[x];
  }
}

// One slice k, blurred along i and then along j. `slice` has dims.x * dims.y values.
void blurSlice(const Volume<float>& volume, int k, const std::array<std::vector<float>, 3>& kernels,
               float* slice) {
  const glm::ivec3 dims = volume.geometry.dims;
  const int radius = int(kernels[0].size()) / 2, across = int(kernels[1].size()) / 2;
  std::vector<float> padded(std::size_t(dims.x + 2 * radius)),
      plane(std::size_t(dims.x) * std::size_t(dims.y));
  std::vector<const float*> rows(kernels[0].size());
  for (std::size_t m = 0; m < rows.size(); ++m) rows[m] = padded.data() + m;
  for (int j = 0; j < dims.y; ++j) {
    const float* row = &volume.at(0, j, k);
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, dims.x, padded.begin() + radius);
    std::fill_n(padded.end() - radius, radius, row[dims.x - 1]);
    weightedSum(rows, kernels[0], plane.data() + std::ptrdiff_t(j) * dims.x, dims.x);
  }
  rows.resize(kernels[1].size());
  for (int j = 0; j < dims.y; ++j) {
    for (int m = -across; m <= across; ++m)
      rows[std::size_t(m + across)] =
          plane.data() + std::ptrdiff_t(std::clamp(j + m, 0, dims.y - 1)) * dims.x;
    weightedSum(rows, kernels[1], slice + std::ptrdiff_t(j) * dims.x, dims.x);
  }
}

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
  const std::array kernels{gaussianKernel(sigma * double(scale.x)), gaussianKernel(sigma * double(scale.y)),
                           gaussianKernel(sigma * double(scale.z))};
  const std::size_t plane = geometry.index(0, 0, 1);
  Volume<float> inPlane(geometry), result(geometry);
  parallelFor(
      geometry.dims.z,
      [&](std::ptrdiff_t k) { blurSlice(volume, int(k), kernels, &inPlane.at(0, 0, int(k))); },
      progress.part(0, 0.7));
  const int radius = int(kernels[2].size()) / 2;
  parallelFor(
      geometry.dims.z,
      [&](std::ptrdiff_t k) {
        std::vector<const float*> slices;
        for (int m = -radius; m <= radius; ++m)
          slices.push_back(&inPlane.at(0, 0, std::clamp(int(k) + m, 0, geometry.dims.z - 1)));
        weightedSum(slices, kernels[2], &result.at(0, 0, int(k)), int(plane));
      },
      progress.part(0.7, 1));
  return result;
}

}  // namespace sonoskin
