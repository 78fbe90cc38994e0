#include "core/classification/tangential_operator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace sonoskin {
namespace {

// A row of numbers for the voxels or cells of a tile's row and one more on both sides.
constexpr int kRowLength = kTileSize.x + 8;
using RowBuffer = std::array<float, kRowLength>;

// K u on one tile. Goes through the cells between voxel planes k and k+1 for rising k, and in them through the rows
// of cells between voxel rows j and j+1. Every loop is one stream of vector instructions over a row.
//   rows     voxel x of the volume is kept at x - first.x + 1, and the cell to its right too
//   a delay  a row's flux is scattered after the next row's is there: reading with a shift of one what was stored
//            just now stalls the processor, which took three times as long
class TileSweep {
 public:
  TileSweep(const Directions& directions, const glm::vec3& scale, float factor, const Tile& tile)
      : directions_(directions),
        dims_(directions.geometry.dims),
        scale_(scale),
        factor_(factor),
        tile_(tile),
        width_(tile.last.x - tile.first.x),
        origin_(tile.first.x - 1),
        firstCell_(std::max(origin_, 0) - origin_),
        endCell_(std::min(tile.last.x, dims_.x - 1) - origin_) {
    for (Flux& flux : flux_)  // there are no cells beyond the volume
      for (RowBuffer* part : {&flux.x, &flux.y, &flux.z}) part->fill(0);
    for (RowBuffer& row : above_) row.fill(0);
  }

  void run(const float* u, const TileRow& row) {
    for (int k = std::max(tile_.first.z - 1, 0); k < tile_.last.z; ++k) cellPlane(u, k, row);
  }

 private:
  struct Flux {
    RowBuffer x, y, z;
  };

  bool hasCells(int j, int k) const { return j >= 0 && j < dims_.y - 1 && k < dims_.z - 1; }
  Flux& fluxOf(int j) { return flux_[std::size_t(j + 1) % 2]; }

  void cellPlane(const float* u, int k, const TileRow& row) {
    lower_.fill(0);
    upper_.fill(0);
    const int begin = tile_.first.y - 1;
    if (hasCells(begin, k)) computeFlux(u, begin, k);
    for (int j = begin; j < tile_.last.y; ++j) {
      if (j + 1 < tile_.last.y && hasCells(j + 1, k)) computeFlux(u, j + 1, k);
      if (j == begin) {
        if (hasCells(j, k)) startRows(fluxOf(j));
        continue;
      }
      float* above = above_[std::size_t(j - tile_.first.y)].data();
      hasCells(j, k) ? scatter(fluxOf(j), above) : finishRow(above);
      if (k >= tile_.first.z) row(j, k, total_.data());
    }
  }

  // Asks for what the rows after next will read: the rows of a tile are too short for the processor to see that
  // they follow each other.
  void fetchAhead(const float* u, std::ptrdiff_t cell) const {
    constexpr int kLine = 64;  // bytes
    for (int x = 0; x < endCell_; x += kLine / int(sizeof(float))) __builtin_prefetch(u + x);
    for (const auto* q : {&directions_.x, &directions_.y, &directions_.z})
      for (int x = 0; x < endCell_; x += kLine) __builtin_prefetch(q->data() + cell + x);
  }

  // F = D grad u in the cells of one row, from the eight voxels around each; components along i, j, k.
  void computeFlux(const float* u, int j, int k) {
    Flux& flux = fluxOf(j);
    const Geometry& g = directions_.geometry;
    const std::ptrdiff_t cell = std::ptrdiff_t(g.index(0, j, k)) + origin_;
    const std::ptrdiff_t up = dims_.x, plane = std::ptrdiff_t(g.index(0, 0, 1));
    const float *a = u + cell, *b = a + up, *c = a + plane, *d = c + up;
    const std::int8_t *qx = directions_.x.data() + cell, *qy = directions_.y.data() + cell,
                      *qz = directions_.z.data() + cell;
    float *fx = flux.x.data(), *fy = flux.y.data(), *fz = flux.z.data();
    const float kx = scale_.x, ky = scale_.y, kz = scale_.z, factor = factor_;
    const int end = endCell_;
    fetchAhead(d + 2 * up, cell + 2 * up);
#pragma omp simd
    for (int x = firstCell_; x < end; ++x) {
      const float a0 = a[x], b0 = b[x], c0 = c[x], d0 = d[x], a1 = a[x + 1], b1 = b[x + 1], c1 = c[x + 1],
                  d1 = d[x + 1];
      const float alongA = a0 + a1, alongB = b0 + b1, alongC = c0 + c1, alongD = d0 + d1;
      const float ux = kx * ((a1 + b1) - (a0 + b0) + ((c1 + d1) - (c0 + d0)));
      const float uy = ky * ((alongB - alongA) + (alongD - alongC));
      const float uz = kz * ((alongC - alongA) + (alongD - alongB));
      const float n = qx[x], m = qy[x], l = qz[x];
      const float norm = factor * (n * n + m * m + l * l), along = factor * (n * ux + m * uy + l * uz);
      fx[x] = kx * (norm * ux - n * along);
      fy[x] = ky * (norm * uy - m * along);
      fz[x] = kz * (norm * uz - l * along);
    }
  }

  // G^T F: every cell adds +-F to its eight voxels; + at the upper corner of each axis.
  void scatter(const Flux& flux, float* above) {
    const float *fx = flux.x.data() + 1, *fy = flux.y.data() + 1, *fz = flux.z.data() + 1;
    float *lower = lower_.data(), *upper = upper_.data(), *total = total_.data();
    const int width = width_;
#pragma omp simd
    for (int x = 0; x < width; ++x) {
      const float p = fx[x - 1] - fx[x], q = fy[x - 1] + fy[x], r = fz[x - 1] + fz[x];
      const float low = p - r, high = p + r;
      total[x] = above[x] + lower[x] + (low - q);
      above[x] = upper[x] + (high - q);
      lower[x] = low + q;
      upper[x] = high + q;
    }
  }

  // What the row of cells before the tile adds to the tile's first voxel row.
  void startRows(const Flux& flux) {
    const float *fx = flux.x.data() + 1, *fy = flux.y.data() + 1, *fz = flux.z.data() + 1;
    float *lower = lower_.data(), *upper = upper_.data();
    const int width = width_;
#pragma omp simd
    for (int x = 0; x < width; ++x) {
      const float p = fx[x - 1] - fx[x], q = fy[x - 1] + fy[x], r = fz[x - 1] + fz[x];
      lower[x] = p - r + q;
      upper[x] = p + r + q;
    }
  }

  // The last row or plane of the volume has no cells of its own.
  void finishRow(float* above) {
    for (int x = 0; x < width_; ++x) {
      const auto at = std::size_t(x);
      total_[at] = above[x] + lower_[at];
      above[x] = upper_[at];
      lower_[at] = upper_[at] = 0;
    }
  }

  const Directions& directions_;
  glm::ivec3 dims_;
  glm::vec3 scale_;
  float factor_;
  Tile tile_;
  int width_, origin_, firstCell_, endCell_;
  Flux flux_[2];                              // of two rows of cells
  std::array<RowBuffer, kTileSize.y> above_;  // what plane k+1 has received so far
  RowBuffer lower_, upper_, total_;  // what rows (j+1, k) and (j+1, k+1) have received; the finished row
};

}  // namespace

TangentialOperator::TangentialOperator(std::shared_ptr<const Directions> directions, double beta)
    : directions_(std::move(directions)),
      scale_(directions_->geometry.axisScale()),
      factor_(float(beta / (127.0 * 127.0 * 16.0))) {}

void TangentialOperator::apply(const float* u, const Tile& tile, const TileRow& row) const {
  TileSweep(*directions_, scale_, factor_, tile).run(u, row);
}

void TangentialOperator::addDiagonalRow(int j, int k, float* out) const {
  const Geometry& g = geometry();
  const float sx = scale_.x, sy = scale_.y, sz = scale_.z, norm = glm::dot(scale_, scale_), factor = factor_;
  const int cells = g.dims.x - 1;
  for (int side = 0; side < 4; ++side) {
    // The row of cells that has these voxels at its upper (bit set) or lower side along j and k.
    const int cellJ = j - (side & 1), cellK = k - (side >> 1);
    if (cellJ < 0 || cellK < 0 || cellJ >= g.dims.y - 1 || cellK >= g.dims.z - 1) continue;
    const float ey = side & 1 ? sy : -sy, ez = side >> 1 ? sz : -sz;
    const std::size_t start = g.index(0, cellJ, cellK);
    const std::int8_t *qx = &directions_->x[start], *qy = &directions_->y[start],
                      *qz = &directions_->z[start];
#pragma omp simd
    for (int i = 0; i < cells; ++i) {
      const float a = qx[i], b = qy[i], c = qz[i];
      const float along = b * ey + c * ez - a * sx;
      out[i] += factor * ((a * a + b * b + c * c) * norm - along * along);
    }
#pragma omp simd
    for (int i = 0; i < cells; ++i) {
      const float a = qx[i], b = qy[i], c = qz[i];
      const float along = b * ey + c * ez + a * sx;
      out[i + 1] += factor * ((a * a + b * b + c * c) * norm - along * along);
    }
  }
}

double TangentialOperator::largestEigenvalue() const {
  constexpr int kSteps = 24;
  const glm::dvec3 s(scale_);
  double largest = 0;
  for (int a = 0; a <= kSteps; ++a)
    for (int b = 0; b <= kSteps; ++b) {
      const double polar = 0.5 * std::numbers::pi * a / kSteps, azimuth = 0.5 * std::numbers::pi * b / kSteps;
      const glm::dvec3 n(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                         std::cos(polar));
      // S D S has rank 2: its eigenvalues follow from its trace and the sum of its principal minors.
      const glm::dvec3 diagonal = s * s * (1.0 - n * n);
      const glm::dvec3 off = -glm::dvec3(s.y * s.z * n.y * n.z, s.z * s.x * n.z * n.x, s.x * s.y * n.x * n.y);
      const double trace = diagonal.x + diagonal.y + diagonal.z;
      const double minors =
          diagonal.x * diagonal.y + diagonal.y * diagonal.z + diagonal.z * diagonal.x - glm::dot(off, off);
      largest = std::max(largest, 0.5 + 0.5 * std::sqrt(std::max(0.0, 1 - 4 * minors / (trace * trace))));
    }
  return 8 * largest;
}

}  // namespace sonoskin
