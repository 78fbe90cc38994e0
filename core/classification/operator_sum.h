#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "core/classification/tiles.h"
#include "core/volume/volume.h"

namespace sonoskin {

// NeighbourTerm: a summand of the functional that couples neighbouring voxels, as the matrix K of its gradient:
// symmetric, positive semi-definite, with natural borders, lengths in units of the smallest spacing.
//   apply              calls row(j, k, K u) once for each row of the tile; reads u at most one voxel around the tile, for
//                      a tile that moves wakes only the six beside it
//   addDiagonalRow     adds the diagonal of K for the voxels (., j, k) of the volume to `out`
//   largestEigenvalue  a bound: K <= bound * diag(K). Too low and sweeps diverge, too high and they are many
template <class T>
concept NeighbourTerm = requires(const T& term, const float* u, const Tile& tile, const TileRow& row, int j,
                                 int k, float* out) {
  { term.geometry() } -> std::same_as<const Geometry&>;
  term.apply(u, tile, row);
  term.addDiagonalRow(j, k, out);
  { term.largestEigenvalue() } -> std::same_as<double>;
};

// OperatorSum: K, the sum of terms of one geometry. Terms are held by value and called without a choice at run time:
// one alone costs what it costs without the sum, each other one an addition per voxel.
template <NeighbourTerm First, NeighbourTerm... Others>
class OperatorSum {
 public:
  explicit OperatorSum(First first, Others... others) : terms_(std::move(first), std::move(others)...) {}

  // apply: as the terms' own.
  void apply(const float* u, const Tile& tile, const TileRow& row) const {
    if constexpr (sizeof...(Others) == 0)
      std::get<0>(terms_).apply(u, tile, row);
    else
      applyAll(u, tile, row);
  }

  // diagonalRow: the diagonal for the voxels (., j, k) of the volume.
  void diagonalRow(int j, int k, float* out) const {
    std::fill_n(out, geometry().dims.x, 0.0f);
    std::apply([&](const auto&... term) { (term.addDiagonalRow(j, k, out), ...); }, terms_);
  }

  // largestEigenvalue: the largest of the bounds, for K1 + K2 <= bound1 diag(K1) + bound2 diag(K2).
  double largestEigenvalue() const {
    return std::apply([](const auto&... term) { return std::max({term.largestEigenvalue()...}); }, terms_);
  }

  const Geometry& geometry() const { return std::get<0>(terms_).geometry(); }

 private:
  // The others' rows wait in the buffer of a tile until the first's are there.
  void applyAll(const float* u, const Tile& tile, const TileRow& row) const {
    const glm::ivec3 size = tile.last - tile.first;
    thread_local std::vector<float> sum;
    sum.assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0.0f);
    const auto added = [&](int j, int k, const float* ku) {
      float* total = &sum[std::size_t((k - tile.first.z) * size.y + j - tile.first.y) * std::size_t(size.x)];
      for (int x = 0; x < size.x; ++x) total[x] += ku[x];
      return total;
    };
    std::apply(
        [&](const First& first, const Others&... other) {
          (other.apply(u, tile, added), ...);
          first.apply(u, tile, [&](int j, int k, const float* ku) { row(j, k, added(j, k, ku)); });
        },
        terms_);
  }

  std::tuple<First, Others...> terms_;
};

}  // namespace sonoskin
