#include "core/volume/box_blur.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace sonoskin {

void boxBlurRow(const Volume<float>& volume, int j, int k, float* scratch, float* out) {
  const glm::ivec3 dims = volume.geometry.dims;
  const float* r[9];
  for (int n = 0; n < 9; ++n)
    r[n] = &volume.at(0, std::clamp(j + n % 3 - 1, 0, dims.y - 1), std::clamp(k + n / 3 - 1, 0, dims.z - 1));
  const float *a = r[0], *b = r[1], *c = r[2], *d = r[3], *e = r[4], *f = r[5], *g = r[6], *h = r[7],
              *l = r[8];
#pragma omp simd
  for (int i = 0; i < dims.x; ++i)
    scratch[i + 1] = (a[i] + b[i] + c[i]) + (d[i] + e[i] + f[i]) + (g[i] + h[i] + l[i]);
  scratch[0] = scratch[1];
  scratch[dims.x + 1] = scratch[dims.x];
#pragma omp simd
  for (int i = 0; i < dims.x; ++i) out[i] = (scratch[i] + scratch[i + 1] + scratch[i + 2]) * (1 / 27.0f);
}

Volume<float> boxBlur(const Volume<float>& volume, const Progress& progress) {
  Volume<float> blurred(volume.geometry);
  parallelFor(
      volume.geometry.dims.z,
      [&](std::ptrdiff_t k) {
        std::vector<float> scratch(std::size_t(volume.geometry.dims.x) + 2);
        for (int j = 0; j < volume.geometry.dims.y; ++j)
          boxBlurRow(volume, j, int(k), scratch.data(), &blurred.at(0, j, int(k)));
      },
      progress);
  return blurred;
}

}  // namespace sonoskin
