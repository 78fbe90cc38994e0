#include "core/classification/scaled_system.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// The scratch rows of one thread, and what it finds.
struct RowWork {
  explicit RowWork(int width)
      : diagonal(std::size_t(width)), right(std::size_t(width)), coupling(std::size_t(width)) {}
  std::vector<float> diagonal, right, coupling;  // c, b; K's diagonal
};

// u to start from: b/c, or the earlier solution moved by the change of b/c. Must come before scaleRow, which
// overwrites the old coefficients.
void startRow(const RowWork& work, const Half* oldRight, const Half* oldOwn, const float* before,
              float* start, int count) {
  const float *c = work.diagonal.data(), *b = work.right.data(), *kDiagonal = work.coupling.data();
  if (before) {
#pragma omp simd
    for (int i = 0; i < count; ++i) {
      const float alone = b[i] / c[i];
      const float moved = std::max(0.0f, before[i] + alone - toFloat(oldRight[i]) / toFloat(oldOwn[i]));
      start[i] = kDiagonal[i] > kLooseCoupling * c[i] ? moved : alone;
    }
  } else {
#pragma omp simd
    for (int i = 0; i < count; ++i) start[i] = b[i] / c[i];
  }
}

// The row divided by the diagonal of A; leaves the share of K in `coupling`.
void scaleRow(RowWork& work, Half* right, Half* own, Half* inverse, int count) {
  const float *c = work.diagonal.data(), *b = work.right.data();
  float* coupling = work.coupling.data();
#pragma omp simd
  for (int i = 0; i < count; ++i) {
    const float d = 1 / (c[i] + coupling[i]);
    right[i] = toHalf(b[i] * d);
    own[i] = toHalf(c[i] * d);
    inverse[i] = toHalf(d);
    coupling[i] = coupling[i] * d;
  }
}

// Adds the row to the values of the tiles that it crosses.
void addToTiles(const RowWork& work, float* coupling, float* squares) {
  const int count = int(work.right.size());
  for (int first = 0; first < count; first += kTileSize.x) {
    const int end = std::min(count, first + kTileSize.x);
    const float *share = work.coupling.data(), *b = work.right.data();
    float largest = *coupling, sum = 0;
#pragma omp simd reduction(max : largest) reduction(+ : sum)
    for (int x = first; x < end; ++x) {
      largest = std::max(largest, share[x]);
      sum += b[x] * b[x];
    }
    *coupling++ = largest;
    *squares++ += sum;
  }
}

}  // namespace

void scaleSystem(const DataSource& source, const NeighbourTerms& k, const float* before, ScaledSystem& system,
                 float* start, const Progress& progress) {
  const Geometry& g = source.raw.geometry;
  for (LargeArray<Half>* part : {&system.right, &system.own, &system.inverse}) part->resize(g.voxels());
  const glm::ivec3 counts = tileCounts(g.dims);
  for (std::vector<float>* perTile : {&system.coupling, &system.squares})
    perTile->assign(std::size_t(counts.x) * std::size_t(counts.y) * std::size_t(counts.z), 0.0f);
  parallelFor(
      counts.z,
      [&](std::ptrdiff_t layer) {
        RowWork work(g.dims.x);
        const int end = std::min((int(layer) + 1) * kTileSize.z, g.dims.z);
        for (int slice = int(layer) * kTileSize.z; slice < end; ++slice) {
          progress.throwIfCancelled();
          for (int j = 0; j < g.dims.y; ++j) {
            const std::size_t at = g.index(0, j, slice);
            Half *right = &system.right[at], *own = &system.own[at], *inverse = &system.inverse[at];
            dataTermRow(source, j, slice, work.diagonal.data(), work.right.data());
            k.diagonalRow(j, slice, work.coupling.data());
            startRow(work, right, own, before ? before + at : nullptr, start + at, g.dims.x);
            scaleRow(work, right, own, inverse, g.dims.x);
            const std::size_t tile =
                (std::size_t(layer) * std::size_t(counts.y) + std::size_t(j / kTileSize.y)) *
                std::size_t(counts.x);
            addToTiles(work, &system.coupling[tile], &system.squares[tile]);
          }
        }
      },
      progress);
  system.norm = std::sqrt(std::accumulate(system.squares.begin(), system.squares.end(), 0.0));
  system.leastOwn = 1 - double(*std::max_element(system.coupling.begin(), system.coupling.end()));
}

}  // namespace sonoskin
