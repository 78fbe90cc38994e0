// The steps from the fitted function to a mesh and the measuring of meshes, each beside the plain way to do the same.
#include <benchmark/benchmark.h>

#include "core/base/parallel.h"
#include "core/mesh/components.h"
#include "core/mesh/iso/marching_cubes.h"
#include "core/mesh/search/mesh_distance.h"
#include "core/rbf/compact/csrbf_model.h"
#include "core/rbf/surface/iso_surface.h"
#include "tests/benchmarks/point_input.h"

namespace sonoskin {
namespace {

const SurfacePoints& points() { return scanPoints(); }

const CsrbfModel& model() {
  static const CsrbfModel fitted = fitCsrbf(points(), ReconstructionOptions{});
  return fitted;
}

void surfaceOnBricks(benchmark::State& state) {
  MeshOptions options;
  options.resolution = int(state.range(0));
  model();  // made before the clock starts
  std::size_t triangles = 0;
  for (auto _ : state) triangles = extractIsoSurface(model(), points(), options).triangles.size();
  state.counters["triangles"] = double(triangles);
}
BENCHMARK(surfaceOnBricks)
    ->Arg(100)
    ->Arg(400)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// The baseline: every node of the box is evaluated, and marching cubes runs over all of it. Neither clip nor normals.
void surfaceOnDenseGrid(benchmark::State& state) {
  const Box box = boundingBox(points().positions);
  const glm::dvec3 extent(box.max - box.min);
  const double cell = std::max({extent.x, extent.y, extent.z}) / double(state.range(0));
  Geometry grid;
  grid.dims = glm::ivec3(extent / cell) + 13;
  grid.spacing = glm::dvec3(cell);
  grid.origin = glm::dvec3(box.min) - 6 * cell;
  std::size_t triangles = 0;
  for (auto _ : state) {
    Volume<float> field(grid);
    parallelFor(grid.dims.z, [&](std::ptrdiff_t k) {
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i)
          field.at(i, j, int(k)) = model().sample(glm::vec3(grid.toWorld({i, j, double(k)}))).value;
    });
    triangles = marchingCubes(field, 0).triangles.size();
  }
  state.counters["triangles"] = double(triangles);
}
BENCHMARK(surfaceOnDenseGrid)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

const Mesh& surface() {
  static const Mesh mesh = extractIsoSurface(model(), points(), MeshOptions{});
  return mesh;
}

void pieces(benchmark::State& state) {
  for (auto _ : state) {
    const std::vector<Mesh> split = splitPieces(surface());
    benchmark::DoNotOptimize(viewShares(split, *phantomInput().beam, glm::dvec3(70, 38, 56)));
  }
  state.counters["triangles"] = double(surface().triangles.size());
}
BENCHMARK(pieces)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void distancesToTruth(benchmark::State& state) {
  static const Mesh truth = makePhantomTruth(PhantomOptions{});
  for (auto _ : state) benchmark::DoNotOptimize(measureDistances(surface(), truth));
  state.counters["vertices"] = double(surface().positions.size() + truth.positions.size());
}
BENCHMARK(distancesToTruth)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
