#include "core/rbf/compact/lambda_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/rbf/compact/centres.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

struct Case {
  SortedPoints points;
  CentreSelection selection;
  std::vector<Centre> centres;  // of the selection
  LambdaSystem system;
};

// The system of these centres, as fitLambda solves it.
LambdaSystem systemOf(const SortedPoints& points, const CentreSelection& selection, FunctionForm form) {
  const CoverageRows byCentre = coverageByCentre(points, selection.centres);
  CoverageRows shares = coverageByPoint(byCentre, points.size());
  if (form == FunctionForm::normalised)
    for (std::size_t k = 0; k < points.size(); ++k)
      for (CoverageEntry* e = shares.begin(k); e < shares.end(k); ++e) e->phi /= selection.overlap[k];
  return sumLambdaSystem(points, shares, valuesAtPoints(selection, form), selection.centres.size());
}

Case makeCase(FunctionForm form = FunctionForm::normalised) {
  ReconstructionOptions options;
  options.smoothness = 6e-4;
  Case c;
  c.points = sortPoints(spherePoints(2000, 12, 0.2), options);
  c.selection = selectCentres(c.points, options);
  c.centres = c.selection.centres;
  c.system = systemOf(c.points, c.selection, form);
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
void expectDefinition(FunctionForm form) {
  const Case c = makeCase(form);
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
    if (form == FunctionForm::normalised) ph.row(k) /= ph.row(k).sum();
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

TEST(LambdaFit, TheSystemEqualsItsDefinition) {
  expectDefinition(FunctionForm::normalised);
  expectDefinition(FunctionForm::plain);
}

TEST(LambdaFit, ColumnsAscend) {
  const Case c = makeCase();
  for (std::size_t i = 0; i < c.system.size(); ++i)
    for (std::size_t e = c.system.rowStart[i] + 1; e < c.system.rowStart[i + 1]; ++e)
      EXPECT_LT(c.system.column[e - 1], c.system.column[e]);
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

// More points and centres than one task takes: lambda still solves its equations, and what is reported is the function.
TEST(LambdaFit, SeveralTasksAreOneFit) {
  ReconstructionOptions reconstruction;
  reconstruction.smoothness = 1e-5;
  const SortedPoints points = sortPoints(spherePoints(9000, 12, 0.05), reconstruction);
  CentreSelection selection = selectCentres(points, reconstruction);
  ASSERT_GT(selection.centres.size(), 1100u);
  const FunctionForm form = FunctionForm::normalised;
  const LambdaSystem A = systemOf(points, selection, form);
  const std::vector<float> values = fitLambda(points, 1e-4, selection, form);
  double missing = 0, right = 0;
  for (std::size_t i = 0; i < A.size(); ++i) {
    const double sigma = double(selection.centres[i].support);
    double left = 1e-4 / (double(A.size()) * sigma * sigma) * double(selection.centres[i].lambda);
    for (std::size_t e = A.rowStart[i]; e < A.rowStart[i + 1]; ++e)
      left += A.value[e] * double(selection.centres[A.column[e]].lambda);
    missing += std::pow(left - A.b[i], 2), right += A.b[i] * A.b[i];
  }
  EXPECT_LT(std::sqrt(missing), 1.1e-4 * std::sqrt(right));
  const CsrbfModel model(selection.centres);
  ASSERT_EQ(values.size(), points.size());
  for (std::size_t k = 0; k < points.size(); k += 7)
    ASSERT_NEAR(values[k], model.sample(points.position(k)).value, 1e-5) << k;
}

// For every regularisation, in both forms; and what is reported is what the function gives.
TEST(LambdaFit, LowersTheGlobalErrorTheMoreTheLessItIsRegularised) {
  for (const FunctionForm form : {FunctionForm::normalised, FunctionForm::plain}) {
    Case c = makeCase(form);
    double last = globalError(c.points, valuesAtPoints(c.selection, form));
    for (const double regularisation : {1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
      const double now = globalError(c.points, fitLambda(c.points, regularisation, c.selection, form));
      EXPECT_LT(now, last);
      last = now;
      if (form == FunctionForm::normalised) {
        EXPECT_NEAR(now, std::sqrt(meanSquare(c.points, c.selection.centres)) / c.points.diagonal,
                    1e-4 * now);
      }
    }
    fitLambda(c.points, 1e6, c.selection, form);
    for (const Centre& centre : c.selection.centres) EXPECT_LT(std::abs(centre.lambda), 1e-4f);
  }
}

// If S_0 is the constant e at all points, λ_i = -e makes S zero there.
TEST(LambdaFit, TakesAConstantOffsetAway) {
  ReconstructionOptions options;
  const SortedPoints points = sortPoints(planePoints(30), options);
  CentreSelection selection = selectCentres(points, options);
  for (Centre& c : selection.centres) c.quadric.f += 0.25f;
  for (float& value : selection.base) value += 0.25f;
  const std::vector<float> values = fitLambda(points, 1e-8, selection);
  EXPECT_LT(std::sqrt(meanSquare(points, selection.centres)), 1e-4);
  EXPECT_LT(globalError(points, values) * points.diagonal, 1e-4);
}

// A quarter turn about z, a shift and a scale of 4: the weights are 4 times as large.
TEST(LambdaFit, WeightsMoveWithThePoints) {
  const SurfacePoints cloud = spherePoints(2000, 12, 0.2);
  SurfacePoints moved = cloud;
  const auto turn = [](const glm::vec3& p) { return glm::vec3(-p.y, p.x, p.z); };
  const auto move = [&](const glm::vec3& p) { return 4.f * turn(p) + glm::vec3(50, -20, 7); };
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    moved.positions[i] = move(cloud.positions[i]);
    moved.normals[i] = turn(cloud.normals[i]);
  }
  ReconstructionOptions options;
  options.smoothness = 6e-4;
  const SortedPoints points = sortPoints(cloud, options), movedPoints = sortPoints(moved, options);
  CentreSelection selection = selectCentres(points, options), movedSelection = selection;
  for (Centre& c : movedSelection.centres) {
    const GlobalQuadric q = c.quadric;
    c = {move(c.position),
         4 * c.support,
         {q.yy / 4, q.xx / 4, q.zz / 4, -q.xy / 4, -q.yz / 4, q.xz / 4, -q.ly, q.lx, q.lz, 4 * q.f},
         0};
  }
  std::vector<std::uint32_t> sortedAs(cloud.size());
  for (std::uint32_t s = 0; s < points.size(); ++s) sortedAs[points.grid.order()[s]] = s;
  for (std::size_t s = 0; s < points.size(); ++s) {
    const std::uint32_t from = sortedAs[movedPoints.grid.order()[s]];
    movedSelection.overlap[s] = selection.overlap[from];
    movedSelection.base[s] = 4 * selection.base[from];
  }
  fitLambda(points, 1e-3, selection);
  fitLambda(movedPoints, 1e-3, movedSelection);
  float largest = 0;
  for (const Centre& c : selection.centres) largest = std::max(largest, std::abs(c.lambda));
  for (std::size_t i = 0; i < selection.centres.size(); ++i)
    EXPECT_NEAR(movedSelection.centres[i].lambda, 4 * selection.centres[i].lambda, 1e-2f * largest);
}

TEST(LambdaFit, TheThreadCountChangesNothing) {
  std::array<std::vector<Centre>, 2> centres;
  for (const int threads : {1, 2}) {
    setThreadCount(threads);
    Case c = makeCase();
    fitLambda(c.points, 1e-4, c.selection);
    centres[std::size_t(threads - 1)] = c.selection.centres;
  }
  setThreadCount(0);
  ASSERT_EQ(centres[0].size(), centres[1].size());
  for (std::size_t i = 0; i < centres[0].size(); ++i) EXPECT_EQ(centres[0][i].lambda, centres[1][i].lambda);
}

TEST(LambdaFit, ProgressRises) {
  Case c = makeCase();
  ProgressSink sink;
  double last = 0;
  sink.report = [&](double fraction) {
    EXPECT_GE(fraction, last - 1e-12);
    last = fraction;
  };
  fitLambda(c.points, 1e-4, c.selection, FunctionForm::normalised, Progress(sink));
  EXPECT_GT(last, 0.8);
  EXPECT_LE(last, 1);
}

TEST(LambdaFit, IsUsedWhenAskedFor) {
  const SurfacePoints points = spherePoints(2000, 12, 0.2);
  ReconstructionOptions options;
  options.smoothness = 6e-4;
  const CsrbfModel plain = fitCsrbf(points, options);
  for (const Centre& c : plain.centres()) EXPECT_EQ(c.lambda, 0);
  EXPECT_FALSE(plain.report().globalErrorWithWeights);
  options.fitWeights = true;
  const CsrbfModel weighted = fitCsrbf(points, options);
  float largest = 0;
  for (const Centre& c : weighted.centres()) largest = std::max(largest, std::abs(c.lambda));
  EXPECT_GT(largest, 0.01f);
  EXPECT_EQ(weighted.report().globalError, plain.report().globalError);
  EXPECT_LT(weighted.report().globalErrorWithWeights.value(), plain.report().globalError);
}

// Without weights and with supports of many points the global error is the noise.
TEST(LambdaFit, TheGlobalErrorIsTheNoise) {
  const SurfacePoints points = planePoints(60, 0.3);
  ReconstructionOptions options;
  options.smoothness = 1e-3;
  const double error = fitCsrbf(points, options).report().globalError;
  EXPECT_NEAR(error * double(boundingBox(points.positions).diagonal()), 0.3, 0.02);
}

TEST(LambdaFit, StopsWhenCancelled) {
  Case c = makeCase();
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(fitLambda(c.points, 1e-4, c.selection, FunctionForm::normalised, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
