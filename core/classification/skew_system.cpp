#include "core/classification/skew_system.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/classification/thesis_system.h"
#include "core/volume/box_blur.h"

namespace sonoskin {
namespace {

constexpr int kMostSweeps = 1000;

// The system with every row divided by its diagonal: u + x (u+x - u-x) + y (u+y - u-y) + z (u+z - u-z) = right.
struct Scaled {
  Geometry geometry;
  LargeArray<float> x, y, z, right;
  double dominance = 0;
};

// The derivative along b (central) and then along a (forward or central); a, b: steps in memory.
struct ForwardOfCentral {
  static float at(const float* v, std::ptrdiff_t a, std::ptrdiff_t b) {
    return 0.5f * ((v[a + b] - v[a - b]) - (v[b] - v[-b]));
  }
};
struct CentralOfCentral {
  static float at(const float* v, std::ptrdiff_t a, std::ptrdiff_t b) {
    return 0.25f * ((v[a + b] - v[a - b]) - (v[b - a] - v[-a - b]));
  }
};

// A row of vectors, one per voxel.
struct VectorRow {
  float *x, *y, *z;
};

// One row of grad v~ x curl grad v~, for inner voxels.
template <class Mixed>
void crossRow(const float* low, const Geometry& g, const VectorRow& out) {
  const std::ptrdiff_t row = g.dims.x, plane = std::ptrdiff_t(g.index(0, 0, 1));
  float *x = out.x, *y = out.y, *z = out.z;
  const int count = g.dims.x;
#pragma omp simd
  for (int i = 1; i < count - 1; ++i) {
    const float* v = low + i;
    const float gx = 0.5f * (v[1] - v[-1]), gy = 0.5f * (v[row] - v[-row]),
                gz = 0.5f * (v[plane] - v[-plane]);
    const float rx = Mixed::at(v, row, plane) - Mixed::at(v, plane, row);
    const float ry = Mixed::at(v, plane, 1) - Mixed::at(v, 1, plane);
    const float rz = Mixed::at(v, 1, row) - Mixed::at(v, row, 1);
    x[i] = gy * rz - gz * ry;
    y[i] = gz * rx - gx * rz;
    z[i] = gx * ry - gy * rx;
  }
}

// Divides a row by its diagonal; returns the greatest sum of |off-diagonals| in it.
float scaleRow(const ThesisRow& row, float halfBeta, int count, const VectorRow& vectors, float* right) {
  float *x = vectors.x, *y = vectors.y, *z = vectors.z, worst = 0;
#pragma omp simd reduction(max : worst)
  for (int i = 0; i < count; ++i) {
    // 0/0 is 0, as in the closed form.
    const float inverse = row.diagonal[i] > 0 ? 1 / row.diagonal[i] : 0;
    const float off = halfBeta * row.edge[i] * inverse;
    right[i] = row.right[i] * inverse;
    x[i] *= off;
    y[i] *= off;
    z[i] *= off;
    const float sum = 2 * (std::abs(x[i]) + std::abs(y[i]) + std::abs(z[i]));
    worst = sum > worst ? sum : worst;
  }
  return worst;
}

Scaled assemble(const Volume<float>& volume, const ClassificationOptions& o, const Progress& progress) {
  const Volume<float> low = boxBlur(volume, progress.part(0, 0.3));
  const Geometry& g = volume.geometry;
  const std::size_t n = g.voxels(), rowSize = std::size_t(g.dims.x);
  Scaled s{g, LargeArray<float>(n, 0.0f), LargeArray<float>(n, 0.0f), LargeArray<float>(n, 0.0f),
           LargeArray<float>(n)};
  const auto cross =
      o.curl == CurlDifferences::forward ? crossRow<ForwardOfCentral> : crossRow<CentralOfCentral>;
  std::vector<float> worst(std::size_t(g.dims.z), 0.0f);
  parallelFor(
      g.dims.z,
      [&](std::ptrdiff_t slice) {
        const int k = int(slice);
        std::vector<float> scratch(3 * rowSize);
        const ThesisRow row{&scratch[0], &scratch[rowSize], &scratch[2 * rowSize]};
        for (int j = 0; j < g.dims.y; ++j) {
          const std::size_t at = g.index(0, j, k);
          const bool inner = j > 0 && k > 0 && j < g.dims.y - 1 && k < g.dims.z - 1;
          const VectorRow vectors{&s.x[at], &s.y[at], &s.z[at]};
          if (inner) cross(&low.data[at], g, vectors);
          thesisRow(volume, &low.data[at], j, k, o, row);
          worst[std::size_t(k)] = std::max(
              worst[std::size_t(k)], scaleRow(row, float(0.5 * o.beta), g.dims.x, vectors, &s.right[at]));
        }
      },
      progress.part(0.3, 1));
  for (const float w : worst) s.dominance = std::max(s.dominance, double(w));
  return s;
}

// One sweep from `u` to `next`: returns the sum of the squared changes, which is that of D^-1 (b - A u). The outermost
// voxels, whose rows are diagonal, are left alone: they have their solution from the start.
double sweep(const Scaled& s, const LargeArray<float>& u, LargeArray<float>& next, const Progress& progress) {
  const Geometry& g = s.geometry;
  const std::ptrdiff_t up = g.dims.x, plane = std::ptrdiff_t(g.index(0, 0, 1));
  std::vector<double> perSlice(std::size_t(g.dims.z), 0.0);
  parallelFor(
      g.dims.z - 2,
      [&](std::ptrdiff_t inner) {
        const int k = int(inner) + 1;
        double sum = 0;
        for (int j = 1; j < g.dims.y - 1; ++j) {
          const std::size_t at = g.index(0, j, k);
          const float *v = &u[at], *x = &s.x[at], *y = &s.y[at], *z = &s.z[at], *right = &s.right[at];
          float *out = &next[at], change = 0;
#pragma omp simd reduction(+ : change)
          for (int i = 1; i < g.dims.x - 1; ++i) {
            const float value = right[i] - x[i] * (v[i + 1] - v[i - 1]) - y[i] * (v[i + up] - v[i - up]) -
                                z[i] * (v[i + plane] - v[i - plane]);
            const float difference = value - v[i];
            out[i] = value;
            change += difference * difference;
          }
          sum += double(change);
        }
        perSlice[std::size_t(k)] = sum;
      },
      progress);
  double sum = 0;
  for (const double s2 : perSlice) sum += s2;
  return sum;
}

double squaredNorm(const LargeArray<float>& values, const Geometry& g) {
  const std::size_t slice = g.index(0, 0, 1);
  std::vector<double> perSlice(std::size_t(g.dims.z), 0.0);
  parallelFor(g.dims.z, [&](std::ptrdiff_t k) {
    const float* v = values.data() + std::size_t(k) * slice;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < slice; ++i) sum += double(v[i]) * double(v[i]);
    perSlice[std::size_t(k)] = sum;
  });
  double sum = 0;
  for (const double s : perSlice) sum += s;
  return sum;
}

// How far a run is whose residual has fallen from `first` to `now` on its way to `last`: residuals fall by factors.
double shareDone(double first, double now, double last) {
  if (first <= last) return 1;
  return std::clamp(std::log(first / std::max(now, 1e-300)) / std::log(first / last), 0.0, 1.0);
}

}  // namespace

SkewSolution solveSkewSystem(const Volume<float>& volume, const ClassificationOptions& o,
                             const Progress& progress) {
  const Scaled system = assemble(volume, o, progress.part(0, 0.4));
  SkewSolution solution;
  solution.dominance = system.dominance;
  require(system.dominance < 1,
          "the thesis' system is not solvable by sweeps: in one row the entries beside the diagonal add up "
          "to {:.2f} "
          "times the diagonal, and only below 1 do sweeps converge; lower classification.beta below {:.2g} "
          "or choose "
          "the variational formulation",
          system.dominance, o.beta / system.dominance);
  const Progress sweeps = progress.part(0.4, 1);
  const double size = std::max(std::sqrt(squaredNorm(system.right, system.geometry)), 1e-300);
  solution.u.geometry = volume.geometry;
  solution.u.data = system.right;
  LargeArray<float> next = system.right;
  double first = 0;
  do {
    require(
        solution.sweeps < kMostSweeps,
        "the thesis' system did not settle in {} sweeps; lower classification.beta or choose the variational "
        "formulation",
        kMostSweeps);
    solution.residual = std::sqrt(sweep(system, solution.u.data, next, sweeps.cancelOnly())) / size;
    std::swap(solution.u.data, next);
    if (++solution.sweeps == 1) first = solution.residual;
    sweeps.update(shareDone(first, solution.residual, o.tolerance));
  } while (solution.residual > o.tolerance);
  return solution;
}

}  // namespace sonoskin
