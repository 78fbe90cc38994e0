#include "core/rbf/compact/lambda_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

constexpr std::size_t kPointsPerTask = 4096, kRowsPerTask = 1024;
constexpr int kMaxIterations = 1000;
constexpr double kTolerance = 1e-4;

// ph_i(p_k) by point.
CoverageRows findShares(const SortedPoints& points, const CentreSelection& selection, FunctionForm form,
                        const Progress& progress) {
  const CoverageRows byCentre = coverageByCentre(points, selection.centres, progress.part(0, 0.6));
  CoverageRows shares = coverageByPoint(byCentre, points.size(), progress.part(0.6, 1));
  if (form == FunctionForm::plain) return shares;
  parallelItems(points.size(), kPointsPerTask, [&](std::size_t k) {
    for (CoverageEntry* e = shares.begin(k); e < shares.end(k); ++e) e->phi /= selection.overlap[k];
  });
  return shares;
}

std::vector<double> multiply(const LambdaSystem& A, const std::vector<double>& diagonal,
                             const std::vector<double>& x) {
  std::vector<double> y(x.size());
  parallelItems(x.size(), kRowsPerTask, [&](std::size_t i) {
    double sum = diagonal[i] * x[i];
    for (std::size_t e = A.rowStart[i]; e < A.rowStart[i + 1]; ++e) sum += A.value[e] * x[A.column[e]];
    y[i] = sum;
  });
  return y;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

std::vector<double> solveLambda(const LambdaSystem& system, const std::vector<Centre>& centres,
                                double regularisation, const Progress& progress) {
  const std::size_t size = system.size();
  std::vector<double> ridge(size), preconditioner(size), x(size, 0), r = system.b, z(size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto sigma = double(centres[i].support);
    ridge[i] = regularisation / (double(size) * sigma * sigma);
    double diagonal = ridge[i];
    for (std::size_t e = system.rowStart[i]; e < system.rowStart[i + 1]; ++e)
      if (system.column[e] == i) diagonal += system.value[e];
    preconditioner[i] = 1 / diagonal;
  }
  const double target = kTolerance * kTolerance * dot(r, r);
  std::vector<double> p(size, 0);
  double rz = 0;
  for (int iteration = 0; iteration < kMaxIterations && dot(r, r) > target; ++iteration) {
    progress.update(std::min(1.0, iteration / 100.0));
    for (std::size_t i = 0; i < size; ++i) z[i] = preconditioner[i] * r[i];
    const double rzNew = dot(r, z), beta = iteration > 0 ? rzNew / rz : 0;
    rz = rzNew;
    for (std::size_t i = 0; i < size; ++i) p[i] = z[i] + beta * p[i];
    const std::vector<double> q = multiply(system, ridge, p);
    const double alpha = rz / dot(p, q);
    for (std::size_t i = 0; i < size; ++i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
    }
  }
  return x;
}

std::vector<float> fitLambda(const SortedPoints& points, double regularisation, CentreSelection& selection,
                             FunctionForm form, const Progress& progress) {
  const CoverageRows shares = findShares(points, selection, form, progress.part(0, 0.4));
  std::vector<float> values = valuesAtPoints(selection, form);
  const LambdaSystem system =
      sumLambdaSystem(points, shares, values, selection.centres.size(), progress.part(0.4, 0.8));
  const std::vector<double> lambda =
      solveLambda(system, selection.centres, regularisation, progress.part(0.8, 1));
  for (std::size_t i = 0; i < lambda.size(); ++i) selection.centres[i].lambda = float(lambda[i]);
  parallelItems(values.size(), kPointsPerTask, [&](std::size_t k) {
    for (const CoverageEntry* e = shares.begin(k); e < shares.end(k); ++e)
      values[k] += e->phi * selection.centres[e->other].lambda;
  });
  return values;
}

double globalError(const SortedPoints& points, const std::vector<float>& values) {
  double sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    sum += double(points.influence[k]) * double(values[k]) * double(values[k]);
  return std::sqrt(sum / std::accumulate(points.influence.begin(), points.influence.end(), 0.0)) /
         points.diagonal;
}

std::vector<float> valuesAtPoints(const CentreSelection& selection, FunctionForm form) {
  std::vector<float> values = selection.base;
  if (form == FunctionForm::plain)
    for (std::size_t k = 0; k < values.size(); ++k) values[k] *= selection.overlap[k];
  return values;
}

}  // namespace sonoskin
