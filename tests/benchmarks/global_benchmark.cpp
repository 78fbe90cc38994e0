// The global radial basis function: its fit beside the dense solution, and its surface beside direct sums.
#include <benchmark/benchmark.h>

#include <Eigen/LU>

#include "core/pipeline/pipeline.h"
#include "core/rbf/brick.h"
#include "core/rbf/global/global_fit.h"
#include "core/rbf/global/global_function.h"
#include "core/rbf/global/global_solver.h"
#include "core/rbf/surface/iso_surface.h"
#include "tests/benchmarks/phantom_input.h"

namespace sonoskin {
namespace {

const SurfacePoints& points() {
  static const Results results = [] {
    Pipeline pipeline;
    return pipeline.run(phantomInput(), Parameters{}, Goal::points);
  }();
  return *results.points;
}

// About `count` constraints: every so-many-th point of the simulated scan, and two beside every other of them.
GlobalPoints constraints(std::size_t count) {
  SurfacePoints chosen;
  for (std::size_t k = 0; k < count / 2; ++k) {
    const std::size_t i = k * points().size() / (count / 2);
    chosen.positions.push_back(points().positions[i]);
    chosen.normals.push_back(points().normals[i]);
    chosen.confidence.push_back(1);
  }
  return makeGlobalPoints(chosen, {});
}

GlobalOptions everyPoint(GlobalBasis basis, double tolerance) {
  GlobalOptions options;
  options.basis = basis;
  options.accuracy = 0;
  options.nugget = 0;
  options.tolerance = tolerance;
  return options;
}

void globalFit(benchmark::State& state, GlobalBasis basis) {
  const double tolerance = state.range(0) > 20000 ? 1e-4 : 1e-5;
  const GlobalPoints data = constraints(std::size_t(state.range(0)));
  GlobalFitReport report;
  for (auto _ : state) report = fitGlobal(data, everyPoint(basis, tolerance)).report();
  state.counters["centres"] = double(data.size());
  state.counters["steps"] = report.steps;
  state.counters["residual_um"] = 1000 * report.largestResidual;
}
BENCHMARK_CAPTURE(globalFit, biharmonic, GlobalBasis::biharmonic)
    ->Arg(2000)
    ->Arg(5000)
    ->Arg(10000)
    ->Arg(20000)
    ->Arg(40000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(globalFit, triharmonic, GlobalBasis::triharmonic)
    ->Arg(5000)
    ->Arg(10000)
    ->Arg(20000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// Without the coarse level.
void globalFitOneLevel(benchmark::State& state) {
  const GlobalPoints data = constraints(std::size_t(state.range(0)));
  const UnitFrame frame = unitFrame(data.sites);
  const GlobalSystem system{toUnit(frame, data.sites), {}, 1, 0};
  const Eigen::VectorXd f = Eigen::VectorXd::Map(data.values.data(), Eigen::Index(data.size()));
  GlobalSolution found;
  for (auto _ : state) found = solveGlobal(system, f, {}, {1e-5, 200, {256, 0}});
  state.counters["steps"] = found.steps;
}
BENCHMARK(globalFitOneLevel)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// The baseline: the whole matrix with its polynomial rows, by Eigen.
void globalFitDense(benchmark::State& state) {
  const GlobalPoints data = constraints(std::size_t(state.range(0)));
  const Sites sites = toUnit(unitFrame(data.sites), data.sites);
  const auto n = Eigen::Index(data.size());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 4);
  right.head(n) = Eigen::VectorXd::Map(data.values.data(), n);
  for (auto _ : state) {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n + 4, n + 4);
    m.topLeftCorner(n, n) = kernelMatrix({}, sites);
    m.topRightCorner(n, 4) = monomialMatrix(sites, 1);
    m.bottomLeftCorner(4, n) = m.topRightCorner(n, 4).transpose();
    const Eigen::VectorXd x = m.partialPivLu().solve(right);
    benchmark::DoNotOptimize(x.sum());
  }
}
BENCHMARK(globalFitDense)->Arg(2000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

const std::shared_ptr<const GlobalRbf>& model() {
  static const auto fitted = std::make_shared<const GlobalRbf>(fitGlobal(points(), {}));
  return fitted;
}

// All points with default options: centres are added until the accuracy is reached.
void globalGreedy(benchmark::State& state) {
  points();  // made before the clock starts
  GlobalRbf fitted;
  for (auto _ : state) fitted = fitGlobal(points(), {});
  state.counters["centres"] = double(fitted.size());
  state.counters["constraints"] = double(fitted.report().constraints);
  state.counters["rounds"] = fitted.report().rounds;
}
BENCHMARK(globalGreedy)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void globalSurface(benchmark::State& state) {
  const MeshOptions options;
  const float cell = meshCell(points().positions, options);
  model();
  std::size_t triangles = 0;
  for (auto _ : state)
    triangles = extractIsoSurface(globalFunction(model(), cell), points(), options).triangles.size();
  state.counters["triangles"] = double(triangles);
}
BENCHMARK(globalSurface)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// The baseline: the same with every value by the direct sum.
void globalSurfaceDirect(benchmark::State& state) {
  const MeshOptions options;
  const float cell = meshCell(points().positions, options);
  ImplicitFunction function = globalFunction(model(), cell);
  function.sampleBrick = [cell](const glm::vec3& corner, float* value, float* coverage) {
    Sites nodes;
    for (int n = 0; n < int(kBrickNodes); ++n)
      nodes.push_back(glm::dvec3(corner) + double(cell) * glm::dvec3(nodePlace(n)));
    const std::vector<double> values = model()->values(nodes);
    for (std::size_t n = 0; n < kBrickNodes; ++n) value[n] = float(values[n]), coverage[n] = 1e6f;
  };
  function.gradients = [](const glm::vec3&, std::span<const glm::vec3> positions, glm::vec3* result) {
    for (const glm::vec3& p : positions) *result++ = glm::vec3(model()->gradient(glm::dvec3(p)));
  };
  for (auto _ : state)
    benchmark::DoNotOptimize(extractIsoSurface(function, points(), options).triangles.size());
}
BENCHMARK(globalSurfaceDirect)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
