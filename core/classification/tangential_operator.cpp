#include "core/classification/tangential_operator.h"

#include <cmath>
#include <cstddef>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// The rows of one cell's flux and what they add to the four voxel rows around them, for all cells (., j, k).
// Everything is a row of `width` floats, so that each loop below is one stream of vector instructions.
class SlabSweep {
 public:
  SlabSweep(const Directions& directions, const glm::vec3& scale, float factor)
      : directions_(directions),
        scale_(scale),
        factor_(factor),
        width_(directions.geometry.dims.x),
        above_(std::size_t(width_) * std::size_t(directions.geometry.dims.y)) {
    for (auto* buffer : {&sum_[0], &sum_[1], &difference_[0], &difference_[1], &alongX_, &alongY_, &alongZ_,
                         &lower_, &upper_, &total_})
      buffer->assign(std::size_t(width_) + 1, 0.0f);
    // One more value in front: the flux left of the first cell is zero.
    for (auto* buffer : {&fluxX_, &fluxY_, &fluxZ_}) buffer->assign(std::size_t(width_) + 1, 0.0f);
  }

  // cellPlane: adds the cells between voxel planes k and k+1; hands the finished rows of voxel plane k to
  // `row` when `emit`, and keeps what belongs to plane k+1 for the next call.
  void cellPlane(const float* u, int k, bool emit, const TangentialOperator::Row& row) {
    const glm::ivec3 dims = directions_.geometry.dims;
    const float* here = u + directions_.geometry.index(0, 0, k);
    const bool last = k == dims.z - 1;
    std::fill(lower_.begin(), lower_.end(), 0.0f);
    std::fill(upper_.begin(), upper_.end(), 0.0f);
    if (!last) addPair(here, 0);
    for (int j = 0; j < dims.y; ++j) {
      float* above = above_.data() + std::ptrdiff_t(j) * width_;
      if (last || j == dims.y - 1) {
        finishRow(above);
      } else {
        addPair(here + std::ptrdiff_t(j + 1) * width_, 1);
        flux(directions_.geometry.index(0, j, k));
        scatter(above);
        std::swap(sum_[0], sum_[1]);
        std::swap(difference_[0], difference_[1]);
      }
      if (emit) row(j, k, total_.data());
    }
  }

 private:
  // Sum and difference of a voxel row and the one above it (k+1).
  void addPair(const float* row, int slot) {
    const float* next = row + directions_.geometry.index(0, 0, 1);
    float *sum = sum_[slot].data(), *difference = difference_[slot].data();
#pragma omp simd
    for (int x = 0; x < width_; ++x) {
      sum[x] = row[x] + next[x];
      difference[x] = next[x] - row[x];
    }
  }

  // F = D grad u in the cells of one row, from the eight voxels around each; components along i, j, k.
  void flux(std::size_t cell) {
    const float *sum0 = sum_[0].data(), *sum1 = sum_[1].data();
    const float *diff0 = difference_[0].data(), *diff1 = difference_[1].data();
    float *sx = alongX_.data(), *sy = alongY_.data(), *sz = alongZ_.data();
#pragma omp simd
    for (int x = 0; x < width_; ++x) {
      sx[x] = sum0[x] + sum1[x];
      sy[x] = sum1[x] - sum0[x];
      sz[x] = diff0[x] + diff1[x];
    }
    const std::int8_t *qx = &directions_.x[cell], *qy = &directions_.y[cell], *qz = &directions_.z[cell];
    float *fx = fluxX_.data() + 1, *fy = fluxY_.data() + 1, *fz = fluxZ_.data() + 1;
    const float kx = scale_.x, ky = scale_.y, kz = scale_.z, factor = factor_;
#pragma omp simd
    for (int x = 0; x < width_ - 1; ++x) {
      const float ux = kx * (sx[x + 1] - sx[x]), uy = ky * (sy[x] + sy[x + 1]), uz = kz * (sz[x] + sz[x + 1]);
      const float a = qx[x], b = qy[x], c = qz[x];
      const float norm = factor * (a * a + b * b + c * c), along = factor * (a * ux + b * uy + c * uz);
      fx[x] = kx * (norm * ux - a * along);
      fy[x] = ky * (norm * uy - b * along);
      fz[x] = kz * (norm * uz - c * along);
    }
  }

  // G^T F: every cell adds +-F to its eight voxels; + at the upper corner of each axis.
  void scatter(float* above) {
    const float *fx = fluxX_.data() + 1, *fy = fluxY_.data() + 1, *fz = fluxZ_.data() + 1;
    float *lower = lower_.data(), *upper = upper_.data(), *total = total_.data();
#pragma omp simd
    for (int x = 0; x < width_; ++x) {
      const float p = fx[x - 1] - fx[x], q = fy[x - 1] + fy[x], r = fz[x - 1] + fz[x];
      const float low = p - r, high = p + r;
      total[x] = above[x] + lower[x] + (low - q);
      above[x] = upper[x] + (high - q);
      lower[x] = low + q;
      upper[x] = high + q;
    }
  }

  // The last row or plane has no cells of its own.
  void finishRow(float* above) {
    for (int x = 0; x < width_; ++x) {
      total_[std::size_t(x)] = above[x] + lower_[std::size_t(x)];
      above[x] = upper_[std::size_t(x)];
    }
  }

  const Directions& directions_;
  glm::vec3 scale_;
  float factor_;
  int width_;
  std::vector<float> above_;                   // what plane k+1 has received so far
  std::vector<float> sum_[2], difference_[2];  // of voxel rows j and j+1
  std::vector<float> alongX_, alongY_, alongZ_, fluxX_, fluxY_, fluxZ_;
  std::vector<float> lower_, upper_,
      total_;  // what rows (j+1, k) and (j+1, k+1) have received; the finished row
};

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
}

}  // namespace

Directions cellDirections(const Volume<float>& lowPassed, double kappa, const Progress& progress) {
  const Geometry& geometry = lowPassed.geometry;
  Directions result{geometry, {}, {}, {}};
  for (auto* component : {&result.x, &result.y, &result.z}) component->resize(geometry.voxels());
  parallelFor(
      geometry.dims.z - 1,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < geometry.dims.y - 1; ++j)
          directionRow(lowPassed, geometry.axisScale(), float(kappa), geometry.index(0, j, int(k)), result);
      },
      progress);
  return result;
}

TangentialOperator::TangentialOperator(std::shared_ptr<const Directions> directions, double beta)
    : directions_(std::move(directions)),
      scale_(directions_->geometry.axisScale()),
      factor_(float(beta / (127.0 * 127.0 * 16.0))) {}

void TangentialOperator::forEachRow(const std::vector<float>& u, const Row& row,
                                    const Progress& progress) const {
  const int planes = geometry().dims.z;
  parallelThreads([&](int thread, int threads) {
    const int begin = int(std::int64_t(planes) * thread / threads);
    const int end = int(std::int64_t(planes) * (thread + 1) / threads);
    if (begin == end) return;
    SlabSweep sweep(*directions_, scale_, factor_);
    // The plane before the slab only leaves behind what it adds to the slab's first plane.
    if (begin > 0) sweep.cellPlane(u.data(), begin - 1, false, row);
    for (int k = begin; k < end; ++k) {
      progress.throwIfCancelled();
      sweep.cellPlane(u.data(), k, true, row);
    }
  });
}

void TangentialOperator::diagonalRow(int j, int k, float* out) const {
  const Geometry& g = geometry();
  const float norm = glm::dot(scale_, scale_);
  std::fill_n(out, g.dims.x, 0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    // The cell that has this voxel at its upper (bit set) or lower corner along each axis.
    const glm::ivec3 up(corner & 1, corner >> 1 & 1, corner >> 2);
    const int cellJ = j - up.y, cellK = k - up.z;
    if (cellJ < 0 || cellK < 0 || cellJ >= g.dims.y - 1 || cellK >= g.dims.z - 1) continue;
    const glm::vec3 e = scale_ * (2.0f * glm::vec3(up) - 1.0f);
    const std::size_t start = g.index(0, cellJ, cellK);
    const std::int8_t *qx = &directions_->x[start], *qy = &directions_->y[start],
                      *qz = &directions_->z[start];
    for (int i = up.x; i < g.dims.x - 1 + up.x; ++i) {
      const float a = qx[i - up.x], b = qy[i - up.x], c = qz[i - up.x];
      const float along = a * e.x + b * e.y + c * e.z;
      out[i] += factor_ * ((a * a + b * b + c * c) * norm - along * along);
    }
  }
}

}  // namespace sonoskin
