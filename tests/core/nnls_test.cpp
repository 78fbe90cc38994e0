#include "core/skin/nnls.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace sonoskin {
namespace {

struct Problem {
  Eigen::MatrixXd gram;
  Eigen::VectorXd rhs;
};

Problem randomProblem(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd a(2 * n, n);
  Eigen::VectorXd b(2 * n);
  for (Eigen::Index i = 0; i < a.size(); ++i) a.data()[i] = normal(random) + 0.5;
  for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = normal(random);
  return {a.transpose() * a, a.transpose() * b};
}

double energy(const Problem& p, const Eigen::VectorXd& w) { return w.dot(p.gram * w) - 2 * p.rhs.dot(w); }

// The twin: tries which terms are zero, in every combination.
double leastEnergy(const Problem& p) {
  const int n = int(p.rhs.size());
  double least = 1e300;
  for (int mask = 1; mask < (1 << n); ++mask) {
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n + 1, n + 1);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
    system(n, n) = 0;
    right[n] = 1;
    for (int i = 0; i < n; ++i) {
      if (!(mask >> i & 1)) continue;
      for (int j = 0; j < n; ++j) system(i, j) = mask >> j & 1 ? p.gram(i, j) : 0;
      system(i, n) = system(n, i) = 1;
      right[i] = p.rhs[i];
    }
    const Eigen::VectorXd w = system.fullPivLu().solve(right).head(n);
    if (w.minCoeff() >= 0 && std::abs(w.sum() - 1) < 1e-9) least = std::min(least, energy(p, w));
  }
  return least;
}

std::vector<double> solve(const Problem& p) {
  return nonNegativeShares({p.gram.data(), size_t(p.gram.size())}, {p.rhs.data(), size_t(p.rhs.size())});
}

TEST(Nnls, FindsWhatTryingAllCombinationsFinds) {
  for (int n = 1; n <= 8; ++n)
    for (unsigned seed = 0; seed < 40; ++seed) {
      const Problem p = randomProblem(n, seed);
      const std::vector<double> w = solve(p);
      double sum = 0;
      for (double value : w) {
        EXPECT_GE(value, 0);
        sum += value;
      }
      EXPECT_NEAR(sum, 1, 1e-12);
      EXPECT_NEAR(energy(p, Eigen::Map<const Eigen::VectorXd>(w.data(), n)), leastEnergy(p), 1e-9)
          << n << " " << seed;
    }
}

TEST(Nnls, EqualTermsShare) {
  Problem p;
  p.gram = Eigen::MatrixXd::Ones(3, 3);
  p.rhs = Eigen::VectorXd::Ones(3);
  const std::vector<double> w = solve(p);
  EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-12);
}

}  // namespace
}  // namespace sonoskin
