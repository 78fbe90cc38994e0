// The steps of the iso-surface on a sphere of 113 thousand points at 400 cells, 1.5 million triangles. Beside it, by
// hand: flying_edges.py, which extracts the same sphere from a full grid with VTK.
#include <benchmark/benchmark.h>

#include "core/rbf/brick_mesher.h"
#include "core/rbf/csrbf_function.h"
#include "core/rbf/iso_surface.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

// The sphere, fitted once.
struct Sphere {
  SurfacePoints points = spherePoints(113000, 86, 0.4);
  CsrbfModel model;
  ImplicitFunction function;

  Sphere() {
    ReconstructionOptions options;
    options.smoothness = 2e-5;
    model = fitCsrbf(points, options);
    function = csrbfFunction(model, meshCell(points.positions, MeshOptions{}));
  }
  BrickField sample() const {
    return sampleBricks(function, points.positions, 6 * function.cell, [](const glm::vec3&) { return true; });
  }
};

const Sphere& sphere() {
  static const Sphere made;
  return made;
}

void sampleSphere(benchmark::State& state) {
  sphere();  // made before the clock starts
  std::size_t bricks = 0;
  for (auto _ : state) bricks = sphere().sample().bricks.size();
  state.counters["samples"] = double(bricks * kBrickNodes);
}
BENCHMARK(sampleSphere)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void extractSphere(benchmark::State& state) {
  const BrickField field = sphere().sample();
  std::size_t triangles = 0;
  for (auto _ : state) triangles = meshBricks(field).mesh.triangles.size();
  state.counters["triangles"] = double(triangles);
}
BENCHMARK(extractSphere)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// Both, and normals, the clip by support and the smooth border.
void surfaceOfSphere(benchmark::State& state) {
  sphere();  // made before the clock starts
  for (auto _ : state)
    benchmark::DoNotOptimize(extractIsoSurface(sphere().model, sphere().points, MeshOptions{}));
}
BENCHMARK(surfaceOfSphere)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
