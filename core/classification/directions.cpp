#include "core/classification/directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// 127 g for one row of cells.
void directionRow(const Volume<float>& v, const glm::vec3& scale, float kappa, std::size_t start,
                  Directions& out) {
  const std::ptrdiff_t row = v.geometry.dims.x, plane = std::ptrdiff_t(v.geometry.index(0, 0, 1));
  const float *a = v.data.data() + start, *b = a + row, *c = a + plane, *d = c + row;
  std::int8_t *qx = &out.x[start], *qy = &out.y[start], *qz = &out.z[start];
  const float kx = 0.25f * scale.x, ky = 0.25f * scale.y, kz = 0.25f * scale.z, floor = kappa * kappa;
#pragma omp simd
  for (std::ptrdiff_t x = 0; x < row - 1; ++x) {
    const float i0 = a[x] + b[x] + c[x] + d[x], i1 = a[x + 1] + b[x + 1] + c[x + 1] + d[x + 1];
    const float lowJ = a[x] + a[x + 1] + c[x] + c[x + 1], highJ = b[x] + b[x + 1] + d[x] + d[x + 1];
    const float lowK = a[x] + a[x + 1] + b[x] + b[x + 1], highK = c[x] + c[x + 1] + d[x] + d[x + 1];
    const float gx = kx * (i1 - i0), gy = ky * (highJ - lowJ), gz = kz * (highK - lowK);
    const float f = 127.0f / std::sqrt(gx * gx + gy * gy + gz * gz + floor);
    qx[x] = std::int8_t(int(gx * f + std::copysign(0.5f, gx)));
    qy[x] = std::int8_t(int(gy * f + std::copysign(0.5f, gy)));
    qz[x] = std::int8_t(int(gz * f + std::copysign(0.5f, gz)));
  }
  qx[row - 1] = qy[row - 1] = qz[row - 1] = 0;
}

void clearRow(std::size_t start, std::size_t count, Directions& out) {
  for (auto* component : {&out.x, &out.y, &out.z})
    std::fill_n(component->begin() + std::ptrdiff_t(start), count, std::int8_t(0));
}

}  // namespace

Directions cellDirections(const Volume<float>& lowPassed, double kappa, const Progress& progress) {
  const Geometry& geometry = lowPassed.geometry;
  const glm::ivec3 dims = geometry.dims;
  Directions result{geometry, {}, {}, {}};
  for (auto* component : {&result.x, &result.y, &result.z}) component->resize(geometry.voxels());
  parallelFor(
      dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < dims.y; ++j) {
          const std::size_t start = geometry.index(0, j, int(k));
          if (j == dims.y - 1 || int(k) == dims.z - 1) {
            clearRow(start, std::size_t(dims.x), result);
          } else {
            directionRow(lowPassed, geometry.axisScale(), float(kappa), start, result);
          }
        }
      },
      progress);
  return result;
}

}  // namespace sonoskin
