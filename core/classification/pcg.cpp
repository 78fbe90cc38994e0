#include "core/classification/pcg.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kMaxIterations = 200;

// Sums that many threads add to, per slice, so that the order of addition is fixed.
class SliceSums {
 public:
  explicit SliceSums(int slices) : sums_(std::size_t(slices), 0.0) {}
  void add(int slice, double value) { sums_[std::size_t(slice)] += value; }
  double total() const { return std::accumulate(sums_.begin(), sums_.end(), 0.0); }

 private:
  std::vector<double> sums_;
};

// The state of the iteration: r = b - A u, p the search direction, q = A p.
class Iteration {
 public:
  Iteration(const TangentialOperator& k, const DataTerm& term, const Progress& progress)
      : k_(k), term_(term), progress_(progress), dims_(k.geometry().dims) {
    const std::size_t n = k.geometry().voxels();
    for (auto* v : {&u, &inverse_, &r_, &p_, &q_}) v->resize(n);
    invertDiagonal();
    start();
  }

  double relativeResidual() const { return norm_ > 0 ? std::sqrt(rr_) / norm_ : 0; }

  void step() {
    makeDirection();
    const double length = rz_ / applyToDirection();
    advance(float(length));
  }

  std::vector<float> u;

 private:
  std::size_t slice(int k) const { return k_.geometry().index(0, 0, k); }

  void invertDiagonal() {
    parallelFor(
        dims_.z,
        [&](std::ptrdiff_t k) {
          for (int j = 0; j < dims_.y; ++j) {
            const std::size_t start = k_.geometry().index(0, j, int(k));
            k_.diagonalRow(j, int(k), &inverse_[start]);
            for (std::size_t i = start; i < start + std::size_t(dims_.x); ++i)
              inverse_[i] = 1 / (term_.diagonal[i] + inverse_[i]);
          }
        },
        progress_);
  }

  // u = b/c and r = b - A u = -K u.
  void start() {
    parallelFor(
        dims_.z,
        [&](std::ptrdiff_t k) {
          for (std::size_t i = slice(int(k)); i < slice(int(k) + 1); ++i)
            u[i] = term_.right[i] / term_.diagonal[i];
        },
        progress_);
    SliceSums bb(dims_.z), rz(dims_.z), rr(dims_.z);
    k_.forEachRow(
        u,
        [&](int j, int k, const float* ku) {
          const std::size_t start = k_.geometry().index(0, j, k);
          const float *b = &term_.right[start], *inverse = &inverse_[start];
          float* r = &r_[start];
          float sumB = 0, sumZ = 0, sumR = 0;
#pragma omp simd reduction(+ : sumB, sumZ, sumR)
          for (int i = 0; i < dims_.x; ++i) {
            r[i] = -ku[i];
            sumB += b[i] * b[i];
            sumZ += ku[i] * ku[i] * inverse[i];
            sumR += ku[i] * ku[i];
          }
          bb.add(k, double(sumB));
          rz.add(k, double(sumZ));
          rr.add(k, double(sumR));
        },
        progress_);
    norm_ = std::sqrt(bb.total());
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
          const float *r = &r_[begin], *inverse = &inverse_[begin];
          float* p = &p_[begin];
#pragma omp simd
          for (std::size_t i = 0; i < count; ++i) p[i] = inverse[i] * r[i] + beta * p[i];
        },
        progress_);
  }

  // q = A p; gives p'q.
  double applyToDirection() {
    SliceSums pq(dims_.z);
    k_.forEachRow(
        p_,
        [&](int j, int k, const float* kp) {
          const std::size_t start = k_.geometry().index(0, j, k);
          const float *c = &term_.diagonal[start], *p = &p_[start];
          float* q = &q_[start];
          float sum = 0;
#pragma omp simd reduction(+ : sum)
          for (int i = 0; i < dims_.x; ++i) {
            q[i] = c[i] * p[i] + kp[i];
            sum += q[i] * p[i];
          }
          pq.add(k, double(sum));
        },
        progress_);
    return pq.total();
  }

  // u += length p, r -= length q
  void advance(float length) {
    SliceSums rz(dims_.z), rr(dims_.z);
    parallelFor(
        dims_.z,
        [&](std::ptrdiff_t k) {
          for (int j = 0; j < dims_.y; ++j)
            advanceRow(int(k), k_.geometry().index(0, j, int(k)), length, rz, rr);
        },
        progress_);
    const double before = rz_;
    rz_ = rz.total();
    rr_ = rr.total();
    beta_ = rz_ / before;
  }

  void advanceRow(int k, std::size_t start, float length, SliceSums& rz, SliceSums& rr) {
    const float *p = &p_[start], *q = &q_[start], *inverse = &inverse_[start];
    float *x = &u[start], *r = &r_[start];
    float sumZ = 0, sumR = 0;
#pragma omp simd reduction(+ : sumZ, sumR)
    for (int i = 0; i < dims_.x; ++i) {
      x[i] += length * p[i];
      r[i] -= length * q[i];
      sumZ += r[i] * r[i] * inverse[i];
      sumR += r[i] * r[i];
    }
    rz.add(k, double(sumZ));
    rr.add(k, double(sumR));
  }

  const TangentialOperator& k_;
  const DataTerm& term_;
  Progress progress_;
  glm::ivec3 dims_;
  std::vector<float> inverse_, r_, p_, q_;  // inverse_: 1 / diag(A)
  double norm_ = 0, rz_ = 0, rr_ = 0, beta_ = 0;
};

// How far the residual has come from `first` down to `goal`, on the logarithmic scale on which it falls
// evenly.
double fractionDone(double residual, double first, double goal) {
  if (residual <= goal || first <= goal) return 1;
  return std::clamp(std::log(first / residual) / std::log(first / goal), 0.0, 1.0);
}

}  // namespace

Solution solveClassification(const TangentialOperator& k, const DataTerm& term, double tolerance,
                             const Progress& progress) {
  Iteration iteration(k, term, progress.cancelOnly());
  Solution solution;
  const double first = iteration.relativeResidual();
  solution.residual = first;
  while (solution.residual > tolerance && solution.iterations < kMaxIterations) {
    iteration.step();
    ++solution.iterations;
    solution.residual = iteration.relativeResidual();
    progress.update(fractionDone(solution.residual, first, tolerance));
  }
  solution.u = std::move(iteration.u);
  return solution;
}

}  // namespace sonoskin
