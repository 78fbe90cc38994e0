#include "core/rbf/lambda_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.h"
#include "core/rbf/coverage.h"

namespace sonoskin {
namespace {

constexpr std::size_t kSmallestTask = 16, kMostTasks = 256;  // rows; every task zeroes an array as long as λ
constexpr std::size_t kPointsPerTask = 4096;
constexpr int kMaxIterations = 1000;
constexpr double kTolerance = 1e-4;

std::ptrdiff_t taskCount(std::size_t items, std::size_t perTask) {
  return std::ptrdiff_t((items + perTask - 1) / perTask);
}

// ph_i(p_k) by centre and by point.
struct Shares {
  CoverageRows byCentre, byPoint;
};

Shares findShares(const SortedPoints& points, const CentreSelection& selection, FunctionForm form,
                  const Progress& progress) {
  Shares shares;
  shares.byCentre = coverageByCentre(points, selection.centres, progress.part(0, 0.5));
  if (form == FunctionForm::normalised)
    parallelFor(taskCount(selection.centres.size(), kSmallestTask), [&](std::ptrdiff_t task) {
      const std::size_t first = std::size_t(task) * kSmallestTask;
      const std::size_t last = std::min(selection.centres.size(), first + kSmallestTask);
      for (CoverageEntry* e = shares.byCentre.begin(first); e < shares.byCentre.begin(last); ++e)
        e->phi /= selection.overlap[e->other];
    });
  shares.byPoint = coverageByPoint(shares.byCentre, points.size(), progress.part(0.5, 1));
  return shares;
}

double sumOf(const std::vector<float>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// The upper half of one row of A, and its b.
struct Row {
  std::vector<std::pair<std::uint32_t, double>> entries;
  double b = 0;
};

// The sums over points that A and b consist of.
struct RowAssembler {
  const SortedPoints& points;
  const Shares& shares;
  const std::vector<float>& base;  // S_0
  double scale = 0;                // 1/(L² Σ d)

  // `dense` holds one zero per centre and is left so.
  Row row(std::size_t i, std::vector<double>& dense) const {
    Row result;
    for (const CoverageEntry* e = shares.byCentre.begin(i); e < shares.byCentre.end(i); ++e) {
      const std::size_t k = e->other;
      const double weight = scale * double(points.influence[k]) * double(e->phi);
      result.b -= weight * double(base[k]);
      // Columns from the diagonal on; the others are their mirror image.
      const CoverageEntry* first = shares.byPoint.begin(k);
      for (const CoverageEntry* c = shares.byPoint.end(k); c-- > first && c->other >= i;) {
        if (dense[c->other] == 0) result.entries.emplace_back(c->other, 0.0);
        dense[c->other] += weight * double(c->phi);
      }
    }
    std::sort(result.entries.begin(), result.entries.end());
    for (auto& [column, value] : result.entries) {
      value = dense[column];
      dense[column] = 0;
    }
    return result;
  }
};

LambdaSystem mirror(const std::vector<Row>& rows) {
  LambdaSystem system;
  system.rowStart.assign(rows.size() + 1, 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    system.b.push_back(rows[i].b);
    for (const auto& [column, value] : rows[i].entries) {
      ++system.rowStart[i + 1];
      if (column != i) ++system.rowStart[column + 1];
    }
  }
  std::partial_sum(system.rowStart.begin(), system.rowStart.end(), system.rowStart.begin());
  system.column.resize(system.rowStart.back());
  system.value.resize(system.rowStart.back());
  std::vector<std::size_t> next(system.rowStart.begin(), system.rowStart.end() - 1);
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    system.column[next[row]] = std::uint32_t(column);
    system.value[next[row]++] = value;
  };
  // Rows come in ascending order, so that a row's mirrored columns, which lie below its diagonal, come first.
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [column, value] : rows[i].entries) {
      add(i, column, value);
      if (column != i) add(column, i, value);
    }
  return system;
}

LambdaSystem assemble(const SortedPoints& points, const Shares& shares, const std::vector<float>& base,
                      const Progress& progress) {
  const double scale = 1 / (points.diagonal * points.diagonal * sumOf(points.influence));
  const RowAssembler assembler{points, shares, base, scale};
  std::vector<Row> rows(shares.byCentre.rows());
  const std::size_t perTask = std::max(kSmallestTask, rows.size() / kMostTasks);
  parallelFor(
      taskCount(rows.size(), perTask),
      [&](std::ptrdiff_t task) {
        std::vector<double> dense(rows.size(), 0);
        const std::size_t first = std::size_t(task) * perTask;
        for (std::size_t i = first; i < std::min(rows.size(), first + perTask); ++i)
          rows[i] = assembler.row(i, dense);
      },
      progress);
  return mirror(rows);
}

std::vector<double> multiply(const LambdaSystem& A, const std::vector<double>& diagonal,
                             const std::vector<double>& x) {
  std::vector<double> y(x.size());
  constexpr std::ptrdiff_t kRows = 1024;
  const auto size = std::ptrdiff_t(x.size());
  parallelFor((size + kRows - 1) / kRows, [&](std::ptrdiff_t task) {
    for (auto i = std::size_t(task * kRows); i < std::size_t(std::min(size, (task + 1) * kRows)); ++i) {
      double sum = diagonal[i] * x[i];
      for (std::size_t e = A.rowStart[i]; e < A.rowStart[i + 1]; ++e) sum += A.value[e] * x[A.column[e]];
      y[i] = sum;
    }
  });
  return y;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

LambdaSystem assembleLambdaSystem(const SortedPoints& points, const CentreSelection& selection,
                                  FunctionForm form, const Progress& progress) {
  const Shares shares = findShares(points, selection, form, progress.part(0, 0.4));
  return assemble(points, shares, valuesAtPoints(selection, form), progress.part(0.4, 1));
}

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
  const Shares shares = findShares(points, selection, form, progress.part(0, 0.4));
  std::vector<float> values = valuesAtPoints(selection, form);
  const LambdaSystem system = assemble(points, shares, values, progress.part(0.4, 0.8));
  const std::vector<double> lambda =
      solveLambda(system, selection.centres, regularisation, progress.part(0.8, 1));
  for (std::size_t i = 0; i < lambda.size(); ++i) selection.centres[i].lambda = float(lambda[i]);
  parallelFor(taskCount(values.size(), kPointsPerTask), [&](std::ptrdiff_t task) {
    const std::size_t first = std::size_t(task) * kPointsPerTask;
    for (std::size_t k = first; k < std::min(values.size(), first + kPointsPerTask); ++k)
      for (const CoverageEntry* e = shares.byPoint.begin(k); e < shares.byPoint.end(k); ++e)
        values[k] += e->phi * selection.centres[e->other].lambda;
  });
  return values;
}

double globalError(const SortedPoints& points, const std::vector<float>& values) {
  double sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    sum += double(points.influence[k]) * double(values[k]) * double(values[k]);
  return std::sqrt(sum / sumOf(points.influence)) / points.diagonal;
}

std::vector<float> valuesAtPoints(const CentreSelection& selection, FunctionForm form) {
  std::vector<float> values = selection.base;
  if (form == FunctionForm::plain)
    for (std::size_t k = 0; k < values.size(); ++k) values[k] *= selection.overlap[k];
  return values;
}

}  // namespace sonoskin
