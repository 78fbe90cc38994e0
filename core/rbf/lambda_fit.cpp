#include "core/rbf/lambda_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.h"
#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

constexpr std::ptrdiff_t kRowsPerTask = 16;
constexpr int kMaxIterations = 1000;
constexpr double kTolerance = 1e-4;

// One entry of the sparse matrix ph_i(p_k): by centre `other` is a point, by point it is a centre.
struct Entry {
  std::uint32_t other;
  float ph;
};

struct SparseRows {
  std::vector<std::size_t> start;
  std::vector<Entry> entries;

  const Entry* begin(std::size_t row) const { return entries.data() + start[row]; }
  const Entry* end(std::size_t row) const { return entries.data() + start[row + 1]; }
};

// φ_i(p_k) by centre, from radius queries.
SparseRows coverageByCentre(const SortedPoints& points, const std::vector<Centre>& centres,
                            const Progress& progress) {
  std::vector<std::vector<Entry>> rows(centres.size());
  parallelFor(
      std::ptrdiff_t(centres.size()),
      [&](std::ptrdiff_t i) {
        const Centre& c = centres[std::size_t(i)];
        points.grid.forEachRun(c.position, c.support, [&](std::size_t first, std::size_t last) {
          for (std::size_t k = first; k < last; ++k) {
            const float phi = wendland(glm::distance(points.position(k), c.position) / c.support);
            if (phi > 0) rows[std::size_t(i)].push_back({std::uint32_t(k), phi});
          }
        });
      },
      progress);
  SparseRows result;
  result.start.push_back(0);
  for (const auto& row : rows) {
    result.entries.insert(result.entries.end(), row.begin(), row.end());
    result.start.push_back(result.entries.size());
  }
  return result;
}

SparseRows transpose(const SparseRows& rows, std::size_t columns) {
  SparseRows result;
  result.start.assign(columns + 1, 0);
  for (const Entry& e : rows.entries) ++result.start[e.other + 1];
  for (std::size_t c = 0; c < columns; ++c) result.start[c + 1] += result.start[c];
  std::vector<std::size_t> next(result.start.begin(), result.start.end() - 1);
  result.entries.resize(rows.entries.size());
  for (std::size_t r = 0; r + 1 < rows.start.size(); ++r)
    for (const Entry* e = rows.begin(r); e < rows.end(r); ++e)
      result.entries[next[e->other]++] = {std::uint32_t(r), e->ph};
  return result;
}

// The function with λ = 0 at a point, given the normalised ph of the centres there.
float baseValue(const glm::vec3& p, const Entry* first, const Entry* last,
                const std::vector<Centre>& centres) {
  float sum = 0;
  for (const Entry* e = first; e < last; ++e) {
    const glm::vec3 d = p - centres[e->other].position;
    sum += e->ph * centres[e->other].quadric.value(d.x, d.y, d.z);
  }
  return sum;
}

struct Row {
  std::vector<std::pair<std::uint32_t, double>> entries;
  double b = 0;
};

// The sums over points that A and b consist of.
class RowAssembler {
 public:
  RowAssembler(const SortedPoints& points, const std::vector<Centre>& centres, const Progress& progress)
      : points_(points), byCentre_(coverageByCentre(points, centres, progress)), base_(points.size()) {
    byPoint_ = transpose(byCentre_, points.size());
    coverage_.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      float sum = 0;
      for (const Entry* e = byPoint_.begin(k); e < byPoint_.end(k); ++e) sum += e->ph;
      for (std::size_t i = byPoint_.start[k]; i < byPoint_.start[k + 1]; ++i) byPoint_.entries[i].ph /= sum;
      coverage_[k] = sum;
      base_[k] = baseValue(points.position(k), byPoint_.begin(k), byPoint_.end(k), centres);
    }
    const double total = std::accumulate(points.influence.begin(), points.influence.end(), 0.0);
    scale_ = 1 / (points.diagonal * points.diagonal * total);
  }

  // `dense` holds one zero per centre and is left so.
  Row row(std::size_t i, std::vector<double>& dense) const {
    Row result;
    for (const Entry* e = byCentre_.begin(i); e < byCentre_.end(i); ++e) {
      const std::size_t k = e->other;
      const double weight = scale_ * double(points_.influence[k]) * double(e->ph / coverage_[k]);
      result.b -= weight * double(base_[k]);
      for (const Entry* other = byPoint_.begin(k); other < byPoint_.end(k); ++other) {
        if (dense[other->other] == 0) result.entries.emplace_back(other->other, 0.0);
        dense[other->other] += weight * double(other->ph);
      }
    }
    std::sort(result.entries.begin(), result.entries.end());
    for (auto& [column, value] : result.entries) {
      value = dense[column];
      dense[column] = 0;
    }
    return result;
  }

 private:
  const SortedPoints& points_;
  SparseRows byCentre_, byPoint_;  // φ and normalised ph
  std::vector<float> coverage_, base_;
  double scale_ = 0;
};

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

LambdaSystem assembleLambdaSystem(const SortedPoints& points, const std::vector<Centre>& centres,
                                  const Progress& progress) {
  const RowAssembler assembler(points, centres, progress.part(0, 0.3));
  std::vector<Row> rows(centres.size());
  const auto count = std::ptrdiff_t(centres.size());
  parallelFor((count + kRowsPerTask - 1) / kRowsPerTask,
              [&](std::ptrdiff_t task) {
                std::vector<double> dense(centres.size(), 0);
                for (auto i = std::size_t(task * kRowsPerTask);
                     i < std::size_t(std::min(count, (task + 1) * kRowsPerTask)); ++i)
                  rows[i] = assembler.row(i, dense);
              },
              progress.part(0.3, 1));
  LambdaSystem system;
  system.rowStart.push_back(0);
  for (const Row& row : rows) {
    for (const auto& [column, value] : row.entries) {
      system.column.push_back(column);
      system.value.push_back(value);
    }
    system.rowStart.push_back(system.column.size());
    system.b.push_back(row.b);
  }
  return system;
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

void fitLambda(const SortedPoints& points, double regularisation, std::vector<Centre>& centres,
               const Progress& progress) {
  const LambdaSystem system = assembleLambdaSystem(points, centres, progress.part(0, 0.7));
  const std::vector<double> lambda = solveLambda(system, centres, regularisation, progress.part(0.7, 1));
  for (std::size_t i = 0; i < centres.size(); ++i) centres[i].lambda = float(lambda[i]);
}

}  // namespace sonoskin
