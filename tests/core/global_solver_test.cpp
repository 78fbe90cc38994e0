#include "core/rbf/global/global_solver.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/global_sites.h"

namespace sonoskin {
namespace {

using test::kAllBases;
using test::valueAt;

// The whole matrix with its polynomial rows, by Eigen.
GlobalSolution solveDense(const GlobalSystem& system, const Eigen::VectorXd& f) {
  const Eigen::Index n = f.size(), q = monomialCount(system.degree);
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n + q, n + q);
  m.topLeftCorner(n, n) = kernelMatrix(system.kernel, system.sites);
  m.diagonal().head(n).array() += system.nugget;
  m.topRightCorner(n, q) = monomialMatrix(system.sites, system.degree);
  m.bottomLeftCorner(q, n) = m.topRightCorner(n, q).transpose();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + q);
  right.head(n) = f;
  const Eigen::VectorXd x = m.partialPivLu().solve(right);
  GlobalSolution result;
  result.weights = x.head(n);
  result.polynomial = x.tail(q);
  return result;
}

// Small domains, so that few sites make many of them.
SolverOptions manyDomains(double tolerance) { return {tolerance, 300, {48, 100}}; }

// Signed distances from a sphere, as a fit meets them.
Eigen::VectorXd distances(const Sites& sites) {
  Eigen::VectorXd f(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) f[Eigen::Index(i)] = glm::length(sites[i]) - 0.9;
  return f;
}

TEST(GlobalSolver, EqualsTheDenseSolutionForEveryBasisAndDegree) {
  const Sites sites = test::randomSites(500, 3, true);
  const Eigen::VectorXd f = distances(sites);
  for (const GlobalBasis b : kAllBases)
    for (int degree = minimumDegree(b); degree <= 2; ++degree) {
      const GlobalSystem system{sites, {b, 0.15}, degree, 0};
      const GlobalSolution found = solveGlobal(system, f, {}, manyDomains(1e-10));
      const GlobalSolution dense = solveDense(system, f);
      EXPECT_LT(found.relativeResidual, 2e-10) << int(b) << " " << degree;
      EXPECT_GT(found.steps, 2);
      EXPECT_LT((found.weights - dense.weights).norm(), 1e-5 * dense.weights.norm())
          << int(b) << " " << degree;
      for (const glm::dvec3 p : {glm::dvec3(0.3, 0.2, 0.1), {0.9, 0.2, 0.1}, {1.1, -1, 0.4}})
        EXPECT_NEAR(valueAt(system, found, p), valueAt(system, dense, p), 1e-6) << int(b) << " " << degree;
    }
}

TEST(GlobalSolver, InterpolatesAndItsWeightsHaveNoMoments) {
  const Sites sites = test::randomSites(700, 3, true);
  const Eigen::VectorXd f = distances(sites);
  for (const GlobalBasis b : {GlobalBasis::biharmonic, GlobalBasis::triharmonic}) {
    const GlobalSystem system{sites, {b, 1}, 1, 0};
    const GlobalSolution found = solveGlobal(system, f, {}, manyDomains(1e-8));
    for (std::size_t i = 0; i < sites.size(); i += 7)
      EXPECT_NEAR(valueAt(system, found, sites[i]), f[Eigen::Index(i)], found.largestResidual + 1e-10);
    EXPECT_LT(found.largestResidual, 1e-7);
    EXPECT_LT((monomialMatrix(sites, 1).transpose() * found.weights).norm(), 1e-9 * found.weights.norm());
  }
}

TEST(GlobalSolver, PolynomialsAreReproducedWithoutWeights) {
  const Sites sites = test::randomSites(300);
  for (const GlobalBasis b : kAllBases)
    for (int degree = std::max(0, minimumDegree(b)); degree <= 2; ++degree) {
      const Eigen::VectorXd c = test::randomVector(std::size_t(monomialCount(degree)));
      const GlobalSystem system{sites, {b, 0.3}, degree, 0};
      const GlobalSolution found =
          solveGlobal(system, monomialMatrix(sites, degree) * c, {}, manyDomains(1e-10));
      EXPECT_LT(found.weights.norm(), 1e-8) << int(b);
      EXPECT_LT((found.polynomial - c).norm(), 1e-8) << int(b);
    }
}

// Knots on a line, and the values there.
GlobalSystem onALine(GlobalBasis basis, int degree, const std::vector<double>& knots) {
  GlobalSystem system{{}, {basis, 1}, degree, 0};
  for (const double x : knots) system.sites.push_back({x, 0, 0});
  return system;
}
const std::vector<double> kKnots{-1, -0.7, -0.55, 0, 0.1, 0.6, 1};
const std::vector<double> kValues{0.3, -0.2, 0.5, 0.1, 0.7, -0.6, 0.2};

TEST(GlobalSolver, OnALineBiharmonicIsPiecewiseLinear) {
  const GlobalSystem system = onALine(GlobalBasis::biharmonic, 0, kKnots);
  const Eigen::VectorXd f = Eigen::VectorXd::Map(kValues.data(), Eigen::Index(kValues.size()));
  const GlobalSolution found = solveGlobal(system, f, {}, manyDomains(1e-12));
  for (std::size_t k = 0; k + 1 < kKnots.size(); ++k)
    for (const double t : {0.0, 0.2, 0.5, 0.9})
      EXPECT_NEAR(valueAt(system, found, {kKnots[k] + t * (kKnots[k + 1] - kKnots[k]), 0, 0}),
                  kValues[k] + t * (kValues[k + 1] - kValues[k]), 1e-10);
  EXPECT_NEAR(valueAt(system, found, {1.7, 0, 0}), kValues.back(), 1e-10);
}

// Second derivatives of the natural cubic spline at the knots, by its equations.
Eigen::VectorXd naturalSpline() {
  const auto n = Eigen::Index(kKnots.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const auto i = std::size_t(k);
    const double before = kKnots[i] - kKnots[i - 1], after = kKnots[i + 1] - kKnots[i];
    m(k, k - 1) = before / 6, m(k, k) = (before + after) / 3, m(k, k + 1) = after / 6;
    right[k] = (kValues[i + 1] - kValues[i]) / after - (kValues[i] - kValues[i - 1]) / before;
  }
  return m.partialPivLu().solve(right);
}

TEST(GlobalSolver, OnALineTriharmonicIsTheNaturalCubicSpline) {
  const GlobalSystem system = onALine(GlobalBasis::triharmonic, 1, kKnots);
  const Eigen::VectorXd f = Eigen::VectorXd::Map(kValues.data(), Eigen::Index(kValues.size()));
  const GlobalSolution found = solveGlobal(system, f, {}, manyDomains(1e-12));
  const Eigen::VectorXd bend = naturalSpline();
  for (std::size_t k = 0; k + 1 < kKnots.size(); ++k)
    for (const double t : {0.0, 0.3, 0.5, 0.8}) {
      const double h = kKnots[k + 1] - kKnots[k], s = 1 - t;
      const double spline =
          s * kValues[k] + t * kValues[k + 1] +
          h * h / 6 * ((s * s * s - s) * bend[Eigen::Index(k)] + (t * t * t - t) * bend[Eigen::Index(k) + 1]);
      EXPECT_NEAR(valueAt(system, found, {kKnots[k] + t * h, 0, 0}), spline, 1e-9);
    }
}

// The nugget: from 0, which interpolates, the residual grows and the energy falls.
TEST(GlobalSolver, ANuggetTradesResidualForEnergy) {
  const Sites sites = test::randomSites(300, 3, true);
  const Eigen::VectorXd f = distances(sites) + 0.02 * test::randomVector(sites.size());
  for (const GlobalBasis b : kAllBases) {
    const Eigen::MatrixXd matrix = kernelMatrix({b, 0.15}, sites);
    double lastResidual = -1, lastEnergy = 1e300;
    for (const double nugget : {0.0, 0.01, 0.1, 1.0, 10.0}) {
      const GlobalSystem system{sites, {b, 0.15}, 1, nugget};
      const GlobalSolution found = solveGlobal(system, f, {}, manyDomains(1e-10));
      // What the function misses is ρλ.
      const double residual = nugget * found.weights.norm();
      const double energy = found.weights.dot(matrix * found.weights);
      EXPECT_NEAR(found.largestResidual, nugget * found.weights.lpNorm<Eigen::Infinity>(), 1e-7) << int(b);
      EXPECT_GT(residual, lastResidual) << int(b);
      EXPECT_LT(energy, lastEnergy) << int(b);
      lastResidual = residual, lastEnergy = energy;
    }
  }
}

TEST(GlobalSolver, TheCoarseLevelSavesSteps) {
  const Sites sites = test::randomSites(3000, 3, true);
  const Eigen::VectorXd f = distances(sites);
  const GlobalSystem system{sites, {GlobalBasis::biharmonic, 1}, 1, 0};
  const GlobalSolution both = solveGlobal(system, f, {}, {1e-5, 100, {128, 512}});
  const GlobalSolution one = solveGlobal(system, f, {}, {1e-5, 100, {128, 0}});
  EXPECT_LT(both.steps, 15);
  EXPECT_GT(one.steps, both.steps);
  EXPECT_LE(both.relativeResidual, 1.1e-5);
  EXPECT_LE(one.relativeResidual, 1.1e-5);
}

TEST(GlobalSolver, AGoodStartSavesSteps) {
  const Sites sites = test::randomSites(1000, 3, true);
  const Eigen::VectorXd f = distances(sites);
  const GlobalSystem system{sites, {GlobalBasis::biharmonic, 1}, 1, 0};
  const GlobalSolution first = solveGlobal(system, f, {}, manyDomains(1e-6));
  const GlobalSolution again = solveGlobal(system, f, first.weights, manyDomains(1e-7));
  const GlobalSolution alone = solveGlobal(system, f, {}, manyDomains(1e-7));
  EXPECT_LT(again.steps, alone.steps);
  EXPECT_LE(again.relativeResidual, 1.1e-7);
  EXPECT_LT((again.weights - alone.weights).norm(), 1e-3 * alone.weights.norm());
}

TEST(GlobalSolver, DoesNotDependOnTheThreads) {
  const Sites sites = test::randomSites(1000, 3, true);
  const Eigen::VectorXd f = distances(sites);
  const GlobalSystem system{sites, {GlobalBasis::triharmonic, 1}, 1, 0};
  setThreadCount(1);
  const GlobalSolution one = solveGlobal(system, f, {}, manyDomains(1e-5));
  setThreadCount(2);
  const GlobalSolution two = solveGlobal(system, f, {}, manyDomains(1e-5));
  setThreadCount(0);
  EXPECT_EQ(one.weights, two.weights);
  EXPECT_EQ(one.polynomial, two.polynomial);
}

TEST(GlobalSolver, CanBeCancelledInTheMiddle) {
  const Sites sites = test::randomSites(1000, 3, true);
  ProgressSink sink;
  double reached = 0;
  sink.report = [&](double fraction) {
    reached = fraction;
    if (fraction > 0.3) sink.cancel = true;
  };
  const GlobalSystem system{sites, {GlobalBasis::biharmonic, 1}, 1, 0};
  EXPECT_THROW(solveGlobal(system, distances(sites), {}, manyDomains(1e-9), Progress(sink)), Cancelled);
  EXPECT_GT(reached, 0.3);
  EXPECT_LT(reached, 0.9);
}

TEST(DenseFactors, SolvesWherePolynomialsAreNotIndependent) {
  GlobalSystem system{{}, {GlobalBasis::triharmonic, 1}, 2, 0};
  for (int i = 0; i < 60; ++i) system.sites.push_back({0.1 * (i % 10), 0.15 * (i / 10), 0.5});
  const Eigen::VectorXd f = test::randomVector(60);
  const Eigen::VectorXd w = DenseFactors(system).solve(f);
  const PolynomialSpace polynomials(system.sites, 2);
  EXPECT_EQ(polynomials.rank(), 6);
  Eigen::VectorXd left = f - kernelMatrix(system.kernel, system.sites) * w;
  polynomials.project(left);
  EXPECT_LT(left.norm(), 1e-8);
  EXPECT_LT((monomialMatrix(system.sites, 2).transpose() * w).norm(), 1e-8 * w.norm());
}

}  // namespace
}  // namespace sonoskin
