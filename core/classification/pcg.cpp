#include "core/classification/pcg.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/parallel.h"
#include "core/classification/residual.h"

namespace sonoskin {
namespace {

constexpr int kMaxIterations = 200;

// Sums that many threads add to, per tile or slice, so that the order of addition is fixed.
class PartialSums {
 public:
  explicit PartialSums(std::size_t parts) : sums_(parts, 0.0) {}
  void add(std::size_t part, double value) { sums_[part] += value; }
  double total() const { return std::accumulate(sums_.begin(), sums_.end(), 0.0); }

 private:
  std::vector<double> sums_;
};

// The tiles of all slices but the known ones.
std::vector<Tile> unknownTiles(const glm::ivec3& dims, int known) {
  std::vector<Tile> tiles = tilesOf({dims.x, dims.y, dims.z - known});
  for (Tile& tile : tiles) tile.first.z += known, tile.last.z += known;
  return tiles;
}

// The state of the iteration: r = b - A u, p the search direction, q = A p. u follows one step behind: it is brought up
// to date where p is read anyway.
class Iteration {
 public:
  Iteration(const NeighbourTerms& k, PcgSystem& system, const Progress& progress)
      : k_(k),
        progress_(progress),
        dims_(k.geometry().dims),
        known_(system.known),
        tiles_(unknownTiles(dims_, system.known)),
        u_(system.u),
        diagonal_(system.diagonal),
        r_(system.r),
        p_(system.p),
        q_(system.q),
        inverse_(system.inverse) {
    const std::size_t n = k.geometry().voxels();
    for (auto* v : {&r_, &p_, &q_}) v->resize(n);
    inverse_.resize(n);
    std::fill_n(p_.begin(), slice(known_), 0.0f);
    startAndInvert();
    firstResidual();
  }

  double relativeResidual() const { return norm_ > 0 ? std::sqrt(rr_) / norm_ : 0; }

  void step() {
    makeDirection();
    length_ = float(rz_ / applyToDirection());
    advance();
  }

  // finish: brings u up to date.
  void finish() {
    forEachSlice([&](int k) {
      const std::size_t begin = slice(k), count = slice(1);
      const float *p = &p_[begin], length = length_;
      float* x = &u_[begin];
#pragma omp simd
      for (std::size_t i = 0; i < count; ++i) x[i] += length * p[i];
    });
  }

 private:
  std::size_t slice(int k) const { return k_.geometry().index(0, 0, k); }
  std::size_t slices() const { return std::size_t(dims_.z); }

  template <class Body>
  void forEachSlice(const Body& body) {
    parallelFor(
        dims_.z - known_, [&](std::ptrdiff_t k) { body(known_ + int(k)); }, progress_);
  }

  // forEachTileRow: calls row(tile's number, index of the row's first voxel, its length, K v).
  template <class Row>
  void forEachTileRow(const float* v, const Row& row) {
    parallelFor(
        std::ptrdiff_t(tiles_.size()),
        [&](std::ptrdiff_t t) {
          const Tile& tile = tiles_[std::size_t(t)];
          k_.apply(v, tile, [&](int j, int k, const float* kv) {
            row(std::size_t(t), k_.geometry().index(tile.first.x, j, k), tile.last.x - tile.first.x, kv);
          });
        },
        progress_);
  }

  // u = b/c in the place of b, |b|, and 1/diag(A).
  void startAndInvert() {
    PartialSums bb(slices());
    forEachSlice([&](int k) {
      std::vector<float> kDiagonal(std::size_t(dims_.x));
      for (int j = 0; j < dims_.y; ++j) {
        const std::size_t start = k_.geometry().index(0, j, k);
        k_.diagonalRow(j, k, kDiagonal.data());
        const float *c = &diagonal_[start], *extra = kDiagonal.data();
        float* b = &u_[start];
        Half* inverse = &inverse_[start];
        float sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < dims_.x; ++i) {
          inverse[i] = toHalf(1 / (c[i] + extra[i]));
          sum += b[i] * b[i];
          b[i] = b[i] / c[i];
        }
        bb.add(std::size_t(k), double(sum));
      }
    });
    norm_ = std::sqrt(bb.total());
  }

  // r = b - A u = -K u for u = b/c.
  void firstResidual() {
    PartialSums rz(tiles_.size()), rr(tiles_.size());
    forEachTileRow(u_, [&](std::size_t tile, std::size_t start, int count, const float* ku) {
      const Half* inverse = &inverse_[start];
      float *r = &r_[start], *p = &p_[start];
      float sumZ = 0, sumR = 0;
#pragma omp simd reduction(+ : sumZ, sumR)
      for (int i = 0; i < count; ++i) {
        r[i] = -ku[i];
        p[i] = 0;
        sumZ += ku[i] * ku[i] * toFloat(inverse[i]);
        sumR += ku[i] * ku[i];
      }
      rz.add(tile, double(sumZ));
      rr.add(tile, double(sumR));
    });
    rz_ = rz.total();
    rr_ = rr.total();
  }

  // u += length p of the step before, p = r / diag + beta p
  void makeDirection() {
    const float beta = float(beta_), length = length_;
    forEachSlice([&](int k) {
      const std::size_t begin = slice(k), count = slice(1);
      const float* r = &r_[begin];
      const Half* inverse = &inverse_[begin];
      float *p = &p_[begin], *x = &u_[begin];
#pragma omp simd
      for (std::size_t i = 0; i < count; ++i) {
        x[i] += length * p[i];
        p[i] = toFloat(inverse[i]) * r[i] + beta * p[i];
      }
    });
  }

  // q = A p; gives p'q.
  double applyToDirection() {
    PartialSums pq(tiles_.size());
    forEachTileRow(p_.data(), [&](std::size_t tile, std::size_t start, int count, const float* kp) {
      const float *c = &diagonal_[start], *p = &p_[start];
      float* q = &q_[start];
      float sum = 0;
#pragma omp simd reduction(+ : sum)
      for (int i = 0; i < count; ++i) {
        q[i] = c[i] * p[i] + kp[i];
        sum += q[i] * p[i];
      }
      pq.add(tile, double(sum));
    });
    return pq.total();
  }

  // r -= length q
  void advance() {
    PartialSums rz(slices()), rr(slices());
    forEachSlice([&](int k) {
      for (int j = 0; j < dims_.y; ++j) advanceRow(std::size_t(k), k_.geometry().index(0, j, k), rz, rr);
    });
    const double before = rz_;
    rz_ = rz.total();
    rr_ = rr.total();
    beta_ = rz_ / before;
  }

  void advanceRow(std::size_t slice, std::size_t start, PartialSums& rz, PartialSums& rr) {
    const float *q = &q_[start], length = length_;
    const Half* inverse = &inverse_[start];
    float* r = &r_[start];
    float sumZ = 0, sumR = 0;
#pragma omp simd reduction(+ : sumZ, sumR)
    for (int i = 0; i < dims_.x; ++i) {
      r[i] -= length * q[i];
      sumZ += r[i] * r[i] * toFloat(inverse[i]);
      sumR += r[i] * r[i];
    }
    rz.add(slice, double(sumZ));
    rr.add(slice, double(sumR));
  }

  const NeighbourTerms& k_;
  Progress progress_;
  glm::ivec3 dims_;
  int known_;
  std::vector<Tile> tiles_;
  float* u_;
  LargeArray<float>&diagonal_, &r_, &p_, &q_;  // as in PcgSystem
  LargeArray<Half>& inverse_;
  float length_ = 0;  // of the last step
  double norm_ = 0, rz_ = 0, rr_ = 0, beta_ = 0;
};

}  // namespace

PcgEnd solvePcg(const NeighbourTerms& k, PcgSystem& system, double tolerance, const Progress& progress) {
  Iteration iteration(k, system, progress.cancelOnly());
  PcgEnd end;
  const double first = iteration.relativeResidual();
  end.residual = first;
  while (end.residual > tolerance && end.iterations < kMaxIterations) {
    iteration.step();
    ++end.iterations;
    end.residual = iteration.relativeResidual();
    progress.update(fractionOfResidual(end.residual, first, tolerance));
  }
  iteration.finish();
  return end;
}

Solution solvePcg(const NeighbourTerms& k, DataTerm term, double tolerance, const Progress& progress) {
  Solution solution;
  solution.u = std::move(term.right);
  PcgSystem system{solution.u.data(), 0, std::move(term.diagonal), {}, {}, {}, {}};
  const PcgEnd end = solvePcg(k, system, tolerance, progress);
  solution.iterations = end.iterations;
  solution.residual = end.residual;
  return solution;
}

}  // namespace sonoskin
