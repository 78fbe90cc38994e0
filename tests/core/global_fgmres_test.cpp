#include "core/rbf/global/global_fgmres.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/base/error.h"
#include "tests/support/global_sites.h"

namespace sonoskin {
namespace {

Eigen::MatrixXd someMatrix(Eigen::Index n) {
  Eigen::MatrixXd m(n, n);
  const Eigen::VectorXd v = test::randomVector(std::size_t(n * n));
  for (Eigen::Index i = 0; i < n * n; ++i) m.data()[i] = v[i] / double(n);
  m.diagonal().array() += 1;
  return m;
}

LinearMap times(const Eigen::MatrixXd& m) {
  return [&m](const Eigen::VectorXd& v) { return Eigen::VectorXd(m * v); };
}
Eigen::VectorXd same(const Eigen::VectorXd& v) { return v; }

TEST(GlobalFgmres, SolvesAnUnsymmetricSystem) {
  const Eigen::MatrixXd m = someMatrix(30);
  const Eigen::VectorXd b = test::randomVector(30);
  const FgmresResult found = fgmres(times(m), same, b, {1e-12, 100});
  EXPECT_LT((m * found.x - b).norm(), 1e-11);
  EXPECT_LE(found.steps, 30);
  EXPECT_NEAR(found.residual, (m * found.x - b).norm(), 1e-11);
}

TEST(GlobalFgmres, TheResidualOfFewStepsIsTrue) {
  const Eigen::MatrixXd m = someMatrix(30);
  const Eigen::VectorXd b = test::randomVector(30);
  double last = b.norm();
  for (int steps = 1; steps < 6; ++steps) {
    const FgmresResult found = fgmres(times(m), same, b, {0, steps});
    EXPECT_EQ(found.steps, steps);
    EXPECT_NEAR(found.residual, (m * found.x - b).norm(), 1e-12);
    EXPECT_LT(found.residual, last);
    last = found.residual;
  }
}

TEST(GlobalFgmres, AnExactPreconditionerNeedsOneStep) {
  const Eigen::MatrixXd m = someMatrix(20), inverse = m.inverse();
  const Eigen::VectorXd b = test::randomVector(20);
  const FgmresResult found = fgmres(times(m), times(inverse), b, {1e-10, 100});
  EXPECT_EQ(found.steps, 1);
  EXPECT_LT((m * found.x - b).norm(), 1e-10);
}

// Flexible: the preconditioner may be another one in every step.
TEST(GlobalFgmres, ThePreconditionerMayChange) {
  const Eigen::MatrixXd m = someMatrix(20);
  const Eigen::VectorXd b = test::randomVector(20);
  int calls = 0;
  const auto changing = [&](const Eigen::VectorXd& v) {
    ++calls;
    Eigen::VectorXd result = v;
    for (Eigen::Index i = 0; i < v.size(); ++i) result[i] *= 1 + 0.2 * double((calls + i) % 3);
    return result;
  };
  const FgmresResult found = fgmres(times(m), changing, b, {1e-11, 100});
  EXPECT_LT((m * found.x - b).norm(), 1e-10);
}

TEST(GlobalFgmres, ZeroIsSolvedWithoutAStep) {
  const Eigen::MatrixXd m = someMatrix(5);
  const FgmresResult found = fgmres(times(m), same, Eigen::VectorXd::Zero(5), {1e-10, 100});
  EXPECT_EQ(found.steps, 0);
  EXPECT_EQ(found.x, Eigen::VectorXd::Zero(5));
}

TEST(GlobalFgmres, CanBeCancelled) {
  const Eigen::MatrixXd m = someMatrix(30);
  ProgressSink sink;
  int calls = 0;
  const auto cancelling = [&](const Eigen::VectorXd& v) {
    if (++calls == 3) sink.cancel = true;
    return v;
  };
  EXPECT_THROW(fgmres(times(m), cancelling, test::randomVector(30), {1e-14, 100}, Progress(sink)), Cancelled);
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace sonoskin
