// The steps of the classification, each beside its memory bound, and the solver beside an assembled Eigen system.
#include <benchmark/benchmark.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>
#include <array>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/classification/chebyshev.h"
#include "core/classification/classify.h"
#include "core/classification/coarser_options.h"
#include "core/classification/data_term.h"
#include "core/classification/live_classifier.h"
#include "core/classification/pcg.h"
#include "core/surface/find_surface.h"
#include "core/volume/gaussian.h"
#include "core/volume/resample.h"
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
  const NeighbourTerms k = neighbourTerms(smoothedInput(), optionsForBenchmarks());
  const LargeArray<float>& u = phantomInput().volume->data;
  LargeArray<float> result(u.size());
  const std::vector<Tile> tiles = tilesOf(k.geometry().dims);
  for (auto _ : state)
    parallelFor(std::ptrdiff_t(tiles.size()), [&](std::ptrdiff_t t) {
      const Tile& tile = tiles[std::size_t(t)];
      k.apply(u.data(), tile, [&](int j, int slice, const float* ku) {
        std::copy_n(ku, tile.last.x - tile.first.x, &result[k.geometry().index(tile.first.x, j, slice)]);
      });
    });
  reportBytesPerVoxel(state, 4 + 3 + 4);
}
BENCHMARK(tangentialOperator)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void conjugateGradients(benchmark::State& state) {
  const ClassificationOptions options = optionsForBenchmarks();
  const DataTerm term = dataTerm({*phantomInput().volume, smoothedInput().lowPassed, options});
  const NeighbourTerms k = neighbourTerms(smoothedInput(), options);
  int iterations = 0;
  for (auto _ : state) iterations = solvePcg(k, term, 1e-3).iterations;
  state.counters["iterations"] = iterations;
  reportBytesPerVoxel(state, 67.0 * iterations);
}
BENCHMARK(conjugateGradients)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// From a volume in memory to u: low-pass, directions, coefficients, sweeps to 2e-3; all buffers new.
void firstRun(benchmark::State& state) {
  const Scan& scan = phantomInput();
  for (auto _ : state) {
    const auto smoothed = std::make_shared<const Smoothed>(smooth(*scan.volume, optionsForBenchmarks()));
    LiveClassifier live(scan.volume, smoothed);
    benchmark::DoNotOptimize(live.classify(optionsForBenchmarks()));
  }
}
BENCHMARK(firstRun)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// After the slider of the iso-value has moved by 0.01, on the volume as it is or on a coarser one.
void reRun(benchmark::State& state) {
  auto volume = phantomInput().volume;
  ClassificationOptions options = optionsForBenchmarks();
  for (int level = 0; level < state.range(0); ++level) {
    auto half = std::make_shared<const Volume<float>>(halveResolution(*volume));
    options = coarserOptions(options, half->geometry.minSpacing() / volume->geometry.minSpacing());
    volume = half;
  }
  LiveClassifier live(volume, std::make_shared<const Smoothed>(smooth(*volume, options)));
  live.classify(options);
  for (auto _ : state) {
    options.isoValue = options.isoValue > 0.315 ? 0.31 : 0.32;
    benchmark::DoNotOptimize(live.classify(options));
  }
  state.counters["voxels"] = double(volume->data.size());
}
BENCHMARK(reRun)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// The sweeps alone, with no tile at rest: their traffic beside the triad's.
void chebyshevSweeps(benchmark::State& state) {
  const ClassificationOptions options = optionsForBenchmarks();
  const NeighbourTerms k = neighbourTerms(smoothedInput(), options);
  ScaledSystem system;
  LargeArray<float> u(phantomInput().volume->data.size()), scratch(u.size());
  double voxels = 0;
  for (auto _ : state) {
    state.PauseTiming();
    scaleSystem({*phantomInput().volume, smoothedInput().lowPassed, options}, k, nullptr, system, u.data());
    state.ResumeTiming();
    voxels += double(solveFast(k, system, 2e-3, u, scratch).updates);
  }
  state.counters["updates/voxel"] = voxels / double(u.size()) / double(state.iterations());
  state.counters["bytes/voxel"] = 21;
  state.SetBytesProcessed(std::int64_t(21 * voxels));
}
BENCHMARK(chebyshevSweeps)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

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

constexpr int kSlabSlices = 8;

struct SlabSystem {
  std::shared_ptr<const Volume<float>> volume = std::make_shared<const Volume<float>>(slab(kSlabSlices));
  std::shared_ptr<const Smoothed> smoothed =
      std::make_shared<const Smoothed>(smooth(*volume, optionsForBenchmarks()));
};

// The 27-point matrix of diag(c) + K, from the cells' 8x8 matrices.
Eigen::SparseMatrix<float, Eigen::RowMajor> assemble(const Directions& directions, const DataTerm& term,
                                                     float beta) {
  const Geometry& g = directions.geometry;
  const glm::vec3 scale = g.axisScale();
  std::vector<Eigen::Triplet<float>> entries;
  entries.reserve(g.voxels() * 65);
  for (int k = 0; k + 1 < g.dims.z; ++k)
    for (int j = 0; j + 1 < g.dims.y; ++j)
      for (int i = 0; i + 1 < g.dims.x; ++i) {
        const std::size_t cell = g.index(i, j, k);
        const glm::vec3 q = glm::vec3(directions.x[cell], directions.y[cell], directions.z[cell]) / 127.0f;
        std::array<glm::vec3, 8> corner, turned;
        std::array<int, 8> voxel{};
        for (std::size_t n = 0; n < 8; ++n) {
          const glm::ivec3 up(n & 1, n >> 1 & 1, n >> 2);
          corner[n] = 0.25f * scale * (2.0f * glm::vec3(up) - 1.0f);
          turned[n] = glm::cross(corner[n], q);
          voxel[n] = int(g.index(i + up.x, j + up.y, k + up.z));
        }
        for (std::size_t n = 0; n < 8; ++n)
          for (std::size_t m = 0; m < 8; ++m)
            entries.emplace_back(voxel[n], voxel[m], beta * glm::dot(turned[n], turned[m]));
      }
  for (std::size_t v = 0; v < g.voxels(); ++v) entries.emplace_back(int(v), int(v), term.diagonal[v]);
  Eigen::SparseMatrix<float, Eigen::RowMajor> a{Eigen::Index(g.voxels()), Eigen::Index(g.voxels())};
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

// The fast solver on the slab, one thread: coefficients and sweeps from b/c to 2e-3.
void slabFast(benchmark::State& state) {
  const SlabSystem system;
  setThreadCount(1);
  for (auto _ : state) {
    LiveClassifier live(system.volume, system.smoothed);
    benchmark::DoNotOptimize(live.classify(optionsForBenchmarks()));
  }
  setThreadCount(0);
}
BENCHMARK(slabFast)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// The baseline: the same slab as an assembled matrix, solved by Eigen from the same start to the same tolerance, one
// thread. What a slider costs: the matrix anew, and the iterations.
void slabEigenAssembled(benchmark::State& state) {
  const SlabSystem system;
  setThreadCount(1);
  double solving = 0;
  for (auto _ : state) {
    const DataTerm term = dataTerm({*system.volume, system.smoothed->lowPassed, optionsForBenchmarks()});
    const auto a = assemble(cellDirections(system.smoothed->lowPassed, 0.02), term,
                            float(absoluteBeta(optionsForBenchmarks())));
    const Timer timer;
    const Eigen::Map<const Eigen::VectorXf> b(term.right.data(), Eigen::Index(term.right.size()));
    const Eigen::Map<const Eigen::VectorXf> c(term.diagonal.data(), b.size());
    const Eigen::VectorXf start = b.cwiseQuotient(c);
    Eigen::ConjugateGradient<Eigen::SparseMatrix<float, Eigen::RowMajor>, Eigen::Lower | Eigen::Upper> solver(
        a);
    solver.setTolerance(2e-3f);
    benchmark::DoNotOptimize(Eigen::VectorXf(solver.solveWithGuess(b, start)));
    solving += timer.seconds();
    state.counters["iterations"] = double(solver.iterations());
  }
  setThreadCount(0);
  state.counters["solver_ms"] = 1e3 * solving / double(state.iterations());
}
BENCHMARK(slabEigenAssembled)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// From the classified volume to points, with all that lies between and the volume of what was kept.
void thinningAndClusters(benchmark::State& state) {
  const Scan& scan = phantomInput();
  const Volume<float> u = classify(*scan.volume, smoothedInput(), optionsForBenchmarks());
  const ScanFrame frame{*scan.beam, findFieldOfView(*scan.volume, *scan.beam)};
  const SurfaceInput input{*scan.volume, u, smoothedInput().lowPassed, frame,
                           optionsForBenchmarks().isoValue};
  std::size_t points = 0;
  for (auto _ : state) {
    const FoundSurface found = findSurface(input, SurfaceOptions{});
    benchmark::DoNotOptimize(thinnedVolume(found.voxels, u.geometry));
    points = found.points.size();
  }
  state.counters["points"] = double(points);
}
BENCHMARK(thinningAndClusters)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
