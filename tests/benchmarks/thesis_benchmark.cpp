// The thesis' equation 3.7, on one thread and at full size: ours beside the thesis' way, which stores gradients and
// curls, assembles a sparse matrix of seven entries per row, and runs Eigen's conjugate gradients on its lower
// triangle.
#include <benchmark/benchmark.h>

#include <Eigen/IterativeLinearSolvers>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/classification/skew_system.h"
#include "core/classification/thesis_system.h"
#include "tests/benchmarks/phantom_input.h"
#include "tests/support/thesis_matrix.h"

namespace sonoskin {
namespace {

// The settings of the thesis' baby 2.
ClassificationOptions optionsOf(Formulation formulation) {
  ClassificationOptions o;
  o.formulation = formulation;
  o.alpha = 0.9;
  o.beta = 0.2;
  o.gamma = 0.4;
  o.isoValue = 0.3;
  o.rawShare = 0.5;
  o.gradientFloor = 0.5;
  o.target = 0.9;
  return o;
}

// Whoever measures this has asked for one thread.
struct OneThread {
  OneThread() { setThreadCount(1); }
  ~OneThread() { setThreadCount(0); }
};

void thesisClosedForm(benchmark::State& state) {
  const Volume<float>& volume = *phantomInput().volume;
  const OneThread one;
  const ClassificationOptions options = optionsOf(Formulation::thesisClosed);
  for (auto _ : state) benchmark::DoNotOptimize(classifyThesis(volume, options));
  state.counters["bytes/voxel"] = 20;
  state.SetBytesProcessed(std::int64_t(20 * volume.data.size()) * std::int64_t(state.iterations()));
}
BENCHMARK(thesisClosedForm)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void thesisSkewSweeps(benchmark::State& state) {
  const Volume<float>& volume = *phantomInput().volume;
  const OneThread one;
  ClassificationOptions options = optionsOf(Formulation::thesisSkew);
  options.beta = 0.1 * double(state.range(0));
  SkewSolution solution;
  for (auto _ : state) solution = solveSkewSystem(volume, options);
  state.counters["sweeps"] = solution.sweeps;
  state.counters["off/diagonal"] = solution.dominance;
}
BENCHMARK(thesisSkewSweeps)
    ->ArgName("beta/10")
    ->Arg(2)
    ->Arg(40)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// The thesis' result: not-a-number set to 0, then least and greatest value brought to 0 and 1.
void rescale(Eigen::VectorXf& u) {
  for (float& value : u)
    if (std::isnan(value)) value = 0;
  const float least = u.minCoeff(), greatest = u.maxCoeff();
  u = (u.array() - least) / (greatest - least);
}

void thesisByEigen(benchmark::State& state) {
  const Volume<float>& volume = *phantomInput().volume;
  ClassificationOptions options = optionsOf(Formulation::thesisSkew);
  options.curl = CurlDifferences::central;
  double assembly = 0, solving = 0;
  for (auto _ : state) {
    Timer timer;
    const auto system = test::thesisMatrix<float>(volume, options);
    assembly = timer.seconds();
    timer = Timer();
    Eigen::ConjugateGradient<Eigen::SparseMatrix<float>, Eigen::Lower> solver;
    solver.setMaxIterations(15);
    solver.compute(system.a);
    Eigen::VectorXf u = solver.solve(system.b);
    rescale(u);
    benchmark::DoNotOptimize(u);
    solving = timer.seconds();
    state.counters["iterations"] = double(solver.iterations());
  }
  state.counters["assembly s"] = assembly;
  state.counters["solver s"] = solving;
}
BENCHMARK(thesisByEigen)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
