// The steps of the classification, each beside its memory bound, and the solver beside an assembled Eigen system.
#include <benchmark/benchmark.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include "core/base/parallel.h"
#include "core/classification/classify.h"
#include "core/classification/data_term.h"
#include "core/classification/pcg.h"
#include "core/surface/clusters.h"
#include "core/surface/thinning.h"
#include "core/volume/gaussian.h"
#include "tests/benchmarks/phantom_input.h"

namespace sonoskin {
namespace {

ClassificationOptions optionsForBenchmarks() {
  ClassificationOptions options;
  options.isoValue = 0.31;
  return options;
}

const Smoothed& smoothedInput() {
  static const Smoothed smoothed = smooth(*phantomInput().volume, optionsForBenchmarks());
  return smoothed;
}

void reportBytesPerVoxel(benchmark::State& state, double bytes) {
  state.SetBytesProcessed(
      std::int64_t(bytes * double(phantomInput().volume->data.size()) * double(state.iterations())));
  state.counters["bytes/voxel"] = bytes;
}

// The bound of everything below: a = 0.5 a + b, 12 bytes per voxel, on all threads.
void memoryTriad(benchmark::State& state) {
  const Volume<float>& b = *phantomInput().volume;
  Volume<float> a = b;
  const std::size_t slice = b.geometry.index(0, 0, 1);
  for (auto _ : state)
    parallelFor(b.geometry.dims.z, [&](std::ptrdiff_t k) {
      float* x = a.data.data() + std::size_t(k) * slice;
      const float* y = b.data.data() + std::size_t(k) * slice;
#pragma omp simd
      for (std::size_t i = 0; i < slice; ++i) x[i] = 0.5f * x[i] + y[i];
    });
  reportBytesPerVoxel(state, 12);
}
BENCHMARK(memoryTriad)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void lowPass(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(gaussianBlur(*phantomInput().volume, 1.5));
  reportBytesPerVoxel(state, 16);
}
BENCHMARK(lowPass)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void directions(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(cellDirections(smoothedInput().lowPassed, 0.02));
  reportBytesPerVoxel(state, 7);
}
BENCHMARK(directions)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void tangentialOperator(benchmark::State& state) {
  const TangentialOperator k(smoothedInput().directions, absoluteBeta(optionsForBenchmarks()));
  const std::vector<float>& u = phantomInput().volume->data;
  std::vector<float> result(u.size());
  for (auto _ : state)
    k.forEachRow(u, [&](int j, int slice, const float* ku) {
      std::copy_n(ku, k.geometry().dims.x, &result[k.geometry().index(0, j, slice)]);
    });
  reportBytesPerVoxel(state, 4 + 3 + 4);
}
BENCHMARK(tangentialOperator)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void conjugateGradients(benchmark::State& state) {
  const ClassificationOptions options = optionsForBenchmarks();
  const DataTerm term = dataTerm(*phantomInput().volume, smoothedInput().lowPassed, options);
  const TangentialOperator k(smoothedInput().directions, absoluteBeta(options));
  int iterations = 0;
  for (auto _ : state) iterations = solveClassification(k, term, 1e-3).iterations;
  state.counters["iterations"] = iterations;
  reportBytesPerVoxel(state, 67.0 * iterations);
}
BENCHMARK(conjugateGradients)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// Some slices of the scan, small enough for an assembled matrix.
Volume<float> slab(int slices) {
  const Volume<float>& whole = *phantomInput().volume;
  Volume<float> part;
  part.geometry = whole.geometry;
  part.geometry.dims.z = slices;
  const auto first = whole.data.begin() + std::ptrdiff_t(whole.geometry.index(0, 0, 50));
  part.data.assign(first, first + std::ptrdiff_t(part.geometry.voxels()));
  return part;
}

// The 27-point matrix of diag(c) + K, its columns found by probing every third voxel along each axis at once:
// their stencils do not touch.
Eigen::SparseMatrix<float, Eigen::RowMajor> assemble(const TangentialOperator& k, const DataTerm& term) {
  const Geometry& g = k.geometry();
  std::vector<Eigen::Triplet<float>> entries;
  entries.reserve(g.voxels() * 28);
  setThreadCount(1);
  for (int phase = 0; phase < 27; ++phase) {
    const glm::ivec3 offset(phase % 3, phase / 3 % 3, phase / 9);
    std::vector<float> probe(g.voxels(), 0.0f);
    for (int z = offset.z; z < g.dims.z; z += 3)
      for (int y = offset.y; y < g.dims.y; y += 3)
        for (int x = offset.x; x < g.dims.x; x += 3) probe[g.index(x, y, z)] = 1;
    // The probed voxel that row (i, j, k) touches, per axis.
    const auto column = [](int at, int first, int size) {
      const int n = at - 1 + ((first - (at - 1)) % 3 + 3) % 3;
      return n >= 0 && n < size ? n : -1;
    };
    k.forEachRow(probe, [&](int j, int slice, const float* ku) {
      const int y = column(j, offset.y, g.dims.y), z = column(slice, offset.z, g.dims.z);
      if (y < 0 || z < 0) return;
      for (int i = 0; i < g.dims.x; ++i)
        if (const int x = column(i, offset.x, g.dims.x); x >= 0 && ku[i] != 0)
          entries.emplace_back(int(g.index(i, j, slice)), int(g.index(x, y, z)), ku[i]);
    });
  }
  setThreadCount(0);
  for (std::size_t v = 0; v < g.voxels(); ++v) entries.emplace_back(int(v), int(v), term.diagonal[v]);
  Eigen::SparseMatrix<float, Eigen::RowMajor> a{Eigen::Index(g.voxels()), Eigen::Index(g.voxels())};
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

constexpr int kSlabSlices = 8;

struct SlabSystem {
  Volume<float> volume = slab(kSlabSlices);
  Smoothed smoothed = smooth(volume, optionsForBenchmarks());
  DataTerm term = dataTerm(volume, smoothed.lowPassed, optionsForBenchmarks());
  TangentialOperator k{smoothed.directions, absoluteBeta(optionsForBenchmarks())};
};

void slabConjugateGradients(benchmark::State& state) {
  const SlabSystem system;
  for (auto _ : state) benchmark::DoNotOptimize(solveClassification(system.k, system.term, 1e-3));
}
BENCHMARK(slabConjugateGradients)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// The baseline: the same slab as an assembled matrix, solved by Eigen from the same start. Assembly is not counted.
void slabEigenAssembled(benchmark::State& state) {
  const SlabSystem system;
  const auto a = assemble(system.k, system.term);
  const Eigen::Map<const Eigen::VectorXf> b(system.term.right.data(), Eigen::Index(system.term.right.size()));
  const Eigen::Map<const Eigen::VectorXf> c(system.term.diagonal.data(), b.size());
  const Eigen::VectorXf start = b.cwiseQuotient(c);
  Eigen::ConjugateGradient<Eigen::SparseMatrix<float, Eigen::RowMajor>, Eigen::Lower | Eigen::Upper> solver(
      a);
  solver.setTolerance(1e-3f);
  for (auto _ : state) benchmark::DoNotOptimize(Eigen::VectorXf(solver.solveWithGuess(b, start)));
  state.counters["iterations"] = double(solver.iterations());
}
BENCHMARK(slabEigenAssembled)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void thinningAndClusters(benchmark::State& state) {
  const Scan& scan = phantomInput();
  const Volume<float> u = classify(*scan.volume, smoothedInput(), optionsForBenchmarks());
  const ScanFrame frame{*scan.beam, findFieldOfView(*scan.volume, *scan.beam)};
  std::size_t found = 0;
  for (auto _ : state) {
    const auto voxels = thin(u, smoothedInput().lowPassed, frame, SurfaceOptions{});
    found = dropWeakClusters(voxels, u.geometry, SurfaceOptions{}).size();
  }
  state.counters["points"] = double(found);
}
BENCHMARK(thinningAndClusters)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
