// The steps of the iso-surface at 400 cells: of a sphere, beside which flying_edges.py extracts the same sphere from a full
// grid with VTK, by hand; and of the phantom's whole skin.
#include <benchmark/benchmark.h>

#include "core/rbf/compact/csrbf_function.h"
#include "core/rbf/surface/brick_mesher.h"
#include "core/rbf/surface/iso_surface.h"
#include "tests/benchmarks/point_input.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

enum Shape { sphere, skin };

// Fitted: 113 thousand points and what was fitted to them.
struct Fitted {
  SurfacePoints points;
  CsrbfModel model;
  ImplicitFunction function;

  explicit Fitted(SurfacePoints given) : points(std::move(given)) {
    ReconstructionOptions options;
    options.smoothness = 2e-5;
    model = fitCsrbf(points, options);
    function = csrbfFunction(model, meshCell(points.positions, MeshOptions{}));
  }
  BrickField sample() const {
    return sampleBricks(function, points.positions, 6 * function.cell, [](const glm::vec3&) { return true; });
  }
};

const Fitted& fittedTo(std::int64_t shape) {
  static const Fitted ball(spherePoints(113000, 86, 0.4)), baby(skinPoints(113000));
  return shape == sphere ? ball : baby;
}

void sampleSurface(benchmark::State& state) {
  const Fitted& fitted = fittedTo(state.range(0));  // made before the clock starts
  BrickField field;
  for (auto _ : state) field = fitted.sample();
  const glm::dvec3 grid = double(kBrickEdge) * glm::dvec3(field.map.bricks());
  state.counters["samples"] = double(field.bricks.size() * kBrickNodes);
  state.counters["fullGrid"] = grid.x * grid.y * grid.z;
}
BENCHMARK(sampleSurface)
    ->Arg(sphere)
    ->Arg(skin)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void extractSurface(benchmark::State& state) {
  const BrickField field = fittedTo(state.range(0)).sample();
  std::size_t triangles = 0;
  for (auto _ : state) triangles = meshBricks(field).mesh.triangles.size();
  state.counters["triangles"] = double(triangles);
}
BENCHMARK(extractSurface)
    ->Arg(sphere)
    ->Arg(skin)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// Both, and normals, the clip by support and the smooth border.
void wholeSurface(benchmark::State& state) {
  const Fitted& fitted = fittedTo(state.range(0));  // made before the clock starts
  for (auto _ : state)
    benchmark::DoNotOptimize(extractIsoSurface(fitted.model, fitted.points, MeshOptions{}));
}
BENCHMARK(wholeSurface)
    ->Arg(sphere)
    ->Arg(skin)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace sonoskin
