// The whole way from a volume in memory to the mesh, and what a slider costs once the earlier stages are known.
#include <benchmark/benchmark.h>

#include "core/pipeline/pipeline.h"
#include "tests/benchmarks/phantom_input.h"

namespace sonoskin {
namespace {

void simulation(benchmark::State& state) {
  PhantomOptions options;
  for (auto _ : state) {
    ++options.seed;  // a seed that was not simulated before
    benchmark::DoNotOptimize(makePhantomScan(options));
  }
}
BENCHMARK(simulation)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void volumeToMesh(benchmark::State& state) {
  const Scan& scan = phantomInput();
  Results results;
  for (auto _ : state) {
    Pipeline pipeline;
    results = pipeline.run(scan, Parameters{}, Goal::mesh);
  }
  for (const StageReport& stage : results.stages) state.counters[stage.name + " s"] = stage.seconds;
  state.counters["triangles"] = double(results.mesh->triangles.size());
}
BENCHMARK(volumeToMesh)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void previewAfterSlider(benchmark::State& state) {
  const Scan& scan = phantomInput();
  Pipeline pipeline;
  Parameters parameters;
  pipeline.preview(scan, parameters, Preview::quarter);
  for (auto _ : state) {
    parameters.classification.alpha *= 1.001;
    benchmark::DoNotOptimize(pipeline.preview(scan, parameters, Preview::quarter));
  }
}
BENCHMARK(previewAfterSlider)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void slicesAfterSlider(benchmark::State& state) {
  const Scan& scan = phantomInput();
  Pipeline pipeline;
  Parameters parameters;
  pipeline.run(scan, parameters, Goal::classified);
  for (auto _ : state) {
    parameters.classification.alpha *= 1.001;
    benchmark::DoNotOptimize(pipeline.slices(scan, parameters, scan.volume->geometry.dims / 2));
  }
}
BENCHMARK(slicesAfterSlider)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void classificationAfterSlider(benchmark::State& state) {
  const Scan& scan = phantomInput();
  Pipeline pipeline;
  Parameters parameters;
  pipeline.run(scan, parameters, Goal::classified);
  for (auto _ : state) {
    parameters.classification.alpha *= 1.001;
    benchmark::DoNotOptimize(pipeline.run(scan, parameters, Goal::classified));
  }
}
BENCHMARK(classificationAfterSlider)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
