#include "core/rbf/lambda_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/rbf/centres.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

struct Case {
  SortedPoints points;
  std::vector<Centre> centres;
  LambdaSystem system;
};

Case makeCase() {
  ReconstructionOptions options;
  options.smoothness = 6e-4;
  Case c;
  c.points = sortPoints(spherePoints(2000, 12, 0.2), options);
  c.centres = selectCentres(c.points, options);
  c.system = assembleLambdaSystem(c.points, c.centres);
  return c;
}

Eigen::MatrixXd dense(const LambdaSystem& system) {
  const auto size = Eigen::Index(system.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < system.size(); ++i)
    for (std::size_t e = system.rowStart[i]; e < system.rowStart[i + 1]; ++e)
      A(Eigen::Index(i), Eigen::Index(system.column[e])) += system.value[e];
  return A;
}

double total(const SortedPoints& points) {
  return std::accumulate(points.influence.begin(), points.influence.end(), 0.0);
}

// (L E_global)² = Σ d S² / Σ d
double meanSquare(const SortedPoints& points, const std::vector<Centre>& centres) {
  const CsrbfModel model(centres);
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    sum += double(points.influence[k]) * std::pow(double(model.sample(points.position(k)).value), 2);
  return sum / total(points);
}

// A and b straight from their definitions, with a dense matrix ph.
TEST(LambdaFit, TheSystemEqualsItsDefinition) {
  const Case c = makeCase();
  const auto rows = Eigen::Index(c.points.size()), columns = Eigen::Index(c.centres.size());
  Eigen::MatrixXd ph(rows, columns);
  Eigen::VectorXd d(rows), base(rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const glm::vec3 p = c.points.position(std::size_t(k));
    d[k] = double(c.points.influence[std::size_t(k)]);
    base[k] = 0;
    for (Eigen::Index i = 0; i < columns; ++i) {
      const Centre& centre = c.centres[std::size_t(i)];
      const double t = double(glm::distance(p, centre.position) / centre.support);
      ph(k, i) = t < 1 ? std::pow(1 - t, 4) * (4 * t + 1) : 0;
    }
    ph.row(k) /= ph.row(k).sum();
    for (Eigen::Index i = 0; i < columns; ++i) {
      const glm::vec3 x = p - c.centres[std::size_t(i)].position;
      base[k] += ph(k, i) * double(c.centres[std::size_t(i)].quadric.value(x.x, x.y, x.z));
    }
  }
  const double scale = 1 / (c.points.diagonal * c.points.diagonal * d.sum());
  const Eigen::MatrixXd A = scale * ph.transpose() * d.asDiagonal() * ph;
  const Eigen::VectorXd b = -scale * ph.transpose() * d.cwiseProduct(base);
  EXPECT_LT((dense(c.system) - A).norm(), 1e-5 * A.norm());
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(c.system.b.data(), columns) - b).norm(), 1e-4 * b.norm());
}

TEST(LambdaFit, TheSystemObeysItsLaws) {
  const Case c = makeCase();
  const Eigen::MatrixXd A = dense(c.system);
  EXPECT_LT((A - A.transpose()).norm(), 1e-6 * A.norm());
  EXPECT_NEAR(A.sum() * c.points.diagonal * c.points.diagonal, 1, 1e-5);
  std::size_t nonZero = 0;  // every centre has its right side
  for (const double b : c.system.b) nonZero += b != 0;
  EXPECT_EQ(nonZero, c.centres.size());
  const CsrbfModel model(c.centres);
  double residual = 0;
  for (std::size_t k = 0; k < c.points.size(); ++k)
    residual -= double(c.points.influence[k] * model.sample(c.points.position(k)).value);
  const double expected = residual / (c.points.diagonal * c.points.diagonal * total(c.points));
  EXPECT_NEAR(std::accumulate(c.system.b.begin(), c.system.b.end(), 0.0) / expected, 1, 1e-3);
}

TEST(LambdaFit, ConjugateGradientsEqualADenseSolution) {
  const Case c = makeCase();
  const double regularisation = 1e-3;
  Eigen::MatrixXd A = dense(c.system);
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    const double sigma = double(c.centres[std::size_t(i)].support);
    A(i, i) += regularisation / (double(A.rows()) * sigma * sigma);
  }
  const Eigen::VectorXd exact =
      A.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(c.system.b.data(), A.rows()));
  const std::vector<double> lambda = solveLambda(c.system, c.centres, regularisation);
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(lambda.data(), A.rows()) - exact).norm(), 2e-3 * exact.norm());
}

TEST(LambdaFit, LowersTheResidualTheMoreTheLessItIsRegularised) {
  Case c = makeCase();
  double last = meanSquare(c.points, c.centres);
  for (const double regularisation : {1.0, 1e-3, 1e-5}) {
    fitLambda(c.points, regularisation, c.centres);
    const double now = meanSquare(c.points, c.centres);
    EXPECT_LT(now, last);
    last = now;
  }
  fitLambda(c.points, 1e6, c.centres);
  for (const Centre& centre : c.centres) EXPECT_LT(std::abs(centre.lambda), 1e-4f);
}

// If S_0 is the constant e at all points, λ_i = -e makes S zero there.
TEST(LambdaFit, TakesAConstantOffsetAway) {
  ReconstructionOptions options;
  const SortedPoints points = sortPoints(planePoints(30), options);
  std::vector<Centre> centres = selectCentres(points, options);
  for (Centre& c : centres) c.quadric.f += 0.25f;
  fitLambda(points, 1e-8, centres);
  EXPECT_LT(std::sqrt(meanSquare(points, centres)), 1e-4);
}

TEST(LambdaFit, IsUsedWhenAskedFor) {
  const SurfacePoints points = spherePoints(2000, 12, 0.2);
  ReconstructionOptions options;
  options.smoothness = 6e-4;
  const CsrbfModel plain = fitCsrbf(points, options);
  for (const Centre& c : plain.centres()) EXPECT_EQ(c.lambda, 0);
  options.fitWeights = true;
  const CsrbfModel weighted = fitCsrbf(points, options);
  float largest = 0;
  for (const Centre& c : weighted.centres()) largest = std::max(largest, std::abs(c.lambda));
  EXPECT_GT(largest, 0.01f);
}

TEST(LambdaFit, StopsWhenCancelled) {
  Case c = makeCase();
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(fitLambda(c.points, 1e-4, c.centres, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
