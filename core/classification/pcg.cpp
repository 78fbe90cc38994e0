#include "core/classification/pcg.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/parallel.h"
#include "core/classification/half.h"
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

// The state of the iteration: r = b - A u, p the search direction, q = A p.
class Iteration {
 public:
  Iteration(const NeighbourTerms& k, DataTerm term, const Progress& progress)
      : k_(k),
        progress_(progress),
        dims_(k.geometry().dims),
        tiles_(tilesOf(dims_)),
        diagonal_(std::move(term.diagonal)) {
    u = std::move(term.right);
    const std::size_t n = k.geometry().voxels();
    for (auto* v : {&r_, &p_, &q_}) v->resize(n);
    inverse_.resize(n);
    startAndInvert();
    firstResidual();
  }

  double relativeResidual() const { return norm_ > 0 ? std::sqrt(rr_) / norm_ : 0; }

  void step() {
    makeDirection();
    const double length = rz_ / applyToDirection();
    advance(float(length));
  }

  LargeArray<float> u;

 private:
  std::size_t slice(int k) const { return k_.geometry().index(0, 0, k); }
  std::size_t slices() const { return std::size_t(dims_.z); }

  // forEachTileRow: calls row(tile's number, index of the row's first voxel, its length, K v).
  template <class Row>
  void forEachTileRow(const LargeArray<float>& v, const Row& row) {
    parallelFor(
        std::ptrdiff_t(tiles_.size()),
        [&](std::ptrdiff_t t) {
          const Tile& tile = tiles_[std::size_t(t)];
          k_.apply(v.data(), tile, [&](int j, int k, const float* kv) {
            row(std::size_t(t), k_.geometry().index(tile.first.x, j, k), tile.last.x - tile.first.x, kv);
          });
        },
        progress_);
  }

  // u = b/c in the place of b, |b|, and 1/diag(A).
  void startAndInvert() {
    PartialSums bb(slices());
    parallelFor(
        dims_.z,
        [&](std::ptrdiff_t k) {
          std::vector<float> kDiagonal(std::size_t(dims_.x));
          for (int j = 0; j < dims_.y; ++j) {
            const std::size_t start = k_.geometry().index(0, j, int(k));
            k_.diagonalRow(j, int(k), kDiagonal.data());
            const float *c = &diagonal_[start], *extra = kDiagonal.data();
            float* b = &u[start];
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
        },
        progress_);
    norm_ = std::sqrt(bb.total());
  }

  // r = b - A u = -K u for u = b/c.
  void firstResidual() {
    PartialSums rz(tiles_.size()), rr(tiles_.size());
    forEachTileRow(u, [&](std::size_t tile, std::size_t start, int count, const float* ku) {
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

  // p = r / diag + beta p
  void makeDirection() {
    const float beta = float(beta_);
    parallelFor(
        dims_.z,
        [&](std::ptrdiff_t k) {
          const std::size_t begin = slice(int(k)), count = slice(1);
          const float* r = &r_[begin];
          const Half* inverse = &inverse_[begin];
          float* p = &p_[begin];
#pragma omp simd
          for (std::size_t i = 0; i < count; ++i) p[i] = toFloat(inverse[i]) * r[i] + beta * p[i];
        },
        progress_);
  }

  // q = A p; gives p'q.
  double applyToDirection() {
    PartialSums pq(tiles_.size());
    forEachTileRow(p_, [&](std::size_t tile, std::size_t start, int count, const float* kp) {
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

  // u += length p, r -= length q
  void advance(float length) {
    PartialSums rz(slices()), rr(slices());
    parallelFor(
        dims_.z,
        [&](std::ptrdiff_t k) {
          for (int j = 0; j < dims_.y; ++j)
            advanceRow(std::size_t(k), k_.geometry().index(0, j, int(k)), length, rz, rr);
        },
        progress_);
    const double before = rz_;
    rz_ = rz.total();
    rr_ = rr.total();
    beta_ = rz_ / before;
  }

  void advanceRow(std::size_t slice, std::size_t start, float length, PartialSums& rz, PartialSums& rr) {
    const float *p = &p_[start], *q = &q_[start];
    const Half* inverse = &inverse_[start];
    float *x = &u[start], *r = &r_[start];
    float sumZ = 0, sumR = 0;
#pragma omp simd reduction(+ : sumZ, sumR)
    for (int i = 0; i < dims_.x; ++i) {
      x[i] += length * p[i];
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
  std::vector<Tile> tiles_;
  LargeArray<float> diagonal_, r_, p_, q_;  // diagonal_: c
  LargeArray<Half> inverse_;                // 1 / diag(A); any positive numbers would do for a preconditioner
  double norm_ = 0, rz_ = 0, rr_ = 0, beta_ = 0;
};

}  // namespace

Solution solvePcg(const NeighbourTerms& k, DataTerm term, double tolerance, const Progress& progress) {
  Iteration iteration(k, std::move(term), progress.cancelOnly());
  Solution solution;
  const double first = iteration.relativeResidual();
  solution.residual = first;
  while (solution.residual > tolerance && solution.iterations < kMaxIterations) {
    iteration.step();
    ++solution.iterations;
    solution.residual = iteration.relativeResidual();
    progress.update(fractionOfResidual(solution.residual, first, tolerance));
  }
  solution.u = std::move(iteration.u);
  return solution;
}

}  // namespace sonoskin
