#include "core/classification/directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// 127 g for one row of cells.
void directionRow(const float* a, const Geometry& geometry, float kappa, std::size_t start, Directions& out) {
  const glm::vec3 scale = geometry.axisScale();
  const std::ptrdiff_t row = geometry.dims.x, plane = std::ptrdiff_t(geometry.index(0, 0, 1));
  const float *b = a + row, *c = a + plane, *d = c + row;
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

void setDirections(const Volume<float>& lowPassed, double kappa, const Slab& slab, Directions& result,
                   const Progress& progress) {
  const Geometry geometry = slabGeometry(lowPassed.geometry, slab);
  const glm::ivec3 dims = geometry.dims;
  result.geometry = geometry;
  for (auto* component : {&result.x, &result.y, &result.z}) component->resize(geometry.voxels());
  parallelFor(
      dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < dims.y; ++j) {
          const std::size_t start = geometry.index(0, j, int(k));
          if (j == dims.y - 1 || int(k) == dims.z - 1) {
            clearRow(start, std::size_t(dims.x), result);
          } else {
            const float* row = &lowPassed.at(0, j, slab.first + int(k));
            directionRow(row, geometry, float(kappa), start, result);
          }
        }
      },
      progress);
}

Directions cellDirections(const Volume<float>& lowPassed, double kappa, const Progress& progress) {
  Directions result;
  setDirections(lowPassed, kappa, {0, lowPassed.geometry.dims.z}, result, progress);
  return result;
}

}  // namespace sonoskin
