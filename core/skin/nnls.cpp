#include "core/skin/nnls.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

namespace sonoskin {
namespace {

constexpr int kMost = 8;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost + 1, kMost + 1>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost + 1, 1>;

struct Problem {
  Eigen::Index n;
  std::span<const double> gram, rhs;
  double g(Eigen::Index i, Eigen::Index j) const { return gram[size_t(i * n + j)]; }
  double b(Eigen::Index i) const { return rhs[size_t(i)]; }
};

// The minimum with sum 1 over the free terms alone, of whatever sign; the multiplier comes last.
Vector solveFree(const Problem& problem, const std::vector<Eigen::Index>& free) {
  const Eigen::Index m = Eigen::Index(free.size());
  Matrix system = Matrix::Ones(m + 1, m + 1);
  Vector right = Vector::Ones(m + 1);
  for (Eigen::Index r = 0; r < m; ++r) {
    for (Eigen::Index c = 0; c < m; ++c) system(r, c) = problem.g(free[size_t(r)], free[size_t(c)]);
    system(r, r) *= 1 + 1e-14;  // two equal terms: either will do
    right(r) = problem.b(free[size_t(r)]);
  }
  system(m, m) = 0;
  return system.partialPivLu().solve(right);
}

// Goes from w toward the free solution as far as no share turns negative; true if all the way.
bool moveToward(const Vector& target, std::vector<Eigen::Index>& free, std::vector<double>& w) {
  double share = 1;
  for (size_t k = 0; k < free.size(); ++k) {
    const double from = w[size_t(free[k])], to = target(Eigen::Index(k));
    if (to <= 0) share = std::min(share, from / (from - to));
  }
  for (size_t k = 0; k < free.size(); ++k) {
    double& value = w[size_t(free[k])];
    value += share * (target(Eigen::Index(k)) - value);
    if (target(Eigen::Index(k)) <= 0 && value < 1e-15) value = 0;
  }
  if (share == 1) return true;
  std::erase_if(free, [&](Eigen::Index i) { return w[size_t(i)] == 0; });
  return false;
}

// The fixed term that would lower the energy most, or -1.
Eigen::Index mostWanted(const Problem& problem, const std::vector<double>& w, double multiplier) {
  Eigen::Index best = -1;
  double most = 1e-13;
  for (Eigen::Index i = 0; i < problem.n; ++i) {
    if (w[size_t(i)] > 0) continue;
    double gain = problem.b(i) - multiplier;
    for (Eigen::Index j = 0; j < problem.n; ++j) gain -= problem.g(i, j) * w[size_t(j)];
    if (gain > most) most = gain, best = i;
  }
  return best;
}

}  // namespace

std::vector<double> nonNegativeShares(std::span<const double> gram, std::span<const double> rhs) {
  const Problem problem{Eigen::Index(rhs.size()), gram, rhs};
  assert(problem.n >= 1 && problem.n <= kMost && gram.size() == rhs.size() * rhs.size());
  const auto energyAlone = [&](Eigen::Index i) { return problem.g(i, i) - 2 * problem.b(i); };
  Eigen::Index start = 0;
  for (Eigen::Index i = 1; i < problem.n; ++i)
    if (energyAlone(i) < energyAlone(start)) start = i;
  std::vector<double> w(rhs.size(), 0.0);
  w[size_t(start)] = 1;
  std::vector<Eigen::Index> free{start};
  for (int step = 0; step < 10 * kMost; ++step) {  // ends by itself after about n; the bound is for rounding
    const Vector target = solveFree(problem, free);
    if (!moveToward(target, free, w)) continue;
    const Eigen::Index next = mostWanted(problem, w, target(Eigen::Index(free.size())));
    if (next < 0) break;
    free.push_back(next);
  }
  return w;
}

}  // namespace sonoskin
