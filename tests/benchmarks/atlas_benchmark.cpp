// The steps that make a surface ready to be shown as skin, on a bumpy ball the size of a newborn's head.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

#include "core/mesh/repair/decimate.h"
#include "core/skin/skin_surface.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// 20 * 4^level triangles but a million at the most, 14,000 mm²: bumps of some mm that charts must go around, and noise of 0.05 mm.
const Mesh& head(std::int64_t level) {
  static std::map<std::int64_t, Mesh> heads;
  const auto [found, isNew] = heads.try_emplace(level);
  Mesh& mesh = found->second;
  if (!isNew) return mesh;
  mesh = test::icosphere(int(level), 33, {0, 0, 0});
  std::uint32_t state = 1;
  for (glm::vec3& p : mesh.positions) {
    state = 1664525 * state + 1013904223;
    const float bumps = std::sin(0.25f * p.x) * std::sin(0.3f * p.y + 1) * std::sin(0.28f * p.z + 2);
    p *= 1 + 0.08f * bumps + 0.0015f * (float(state >> 8) / float(1 << 23) - 1);
  }
  constexpr std::size_t kMost = 1000000;
  if (mesh.triangles.size() > kMost) mesh = decimateMesh(mesh, kMost);
  computeNormals(mesh);
  return mesh;
}

AtlasOptions optionsFor(std::int64_t level) {
  AtlasOptions options;
  options.texel = level < 8 ? 0.30 : 0.15;
  return options;
}

void buildCharts(benchmark::State& state) {
  const Mesh& mesh = head(state.range(0));
  Atlas atlas;
  for (auto _ : state) atlas = buildAtlas(mesh, optionsFor(state.range(0)));
  const AtlasCheck check = checkAtlas(mesh, atlas);
  state.counters["triangles"] = double(mesh.triangles.size());
  state.counters["charts"] = check.charts;
  state.counters["overlap"] = check.overlap;
  state.counters["uncovered"] = check.uncovered;
  state.counters["stretch99"] = check.stretch99;
  state.counters["seam"] = check.seamLength;
}

void check(benchmark::State& state) {
  const Mesh& mesh = head(state.range(0));
  const Atlas atlas = buildAtlas(mesh, optionsFor(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(checkAtlas(mesh, atlas));
}

void measure(benchmark::State& state) {
  const Mesh& mesh = head(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(measureTraits(mesh));
}

void bake(benchmark::State& state) {
  const Mesh& mesh = head(state.range(0));
  const Atlas atlas = buildAtlas(mesh, optionsFor(state.range(0)));
  const SurfaceTraits traits = measureTraits(mesh, 8);
  for (auto _ : state) benchmark::DoNotOptimize(bakeAtlas(mesh, traits, atlas));
  state.counters["texels"] = double(atlas.size.x) * double(atlas.size.y);
}

void split(benchmark::State& state) {
  const Mesh& mesh = head(state.range(0));
  const Atlas atlas = buildAtlas(mesh, optionsFor(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(splitAtSeams(mesh, atlas));
}

// Level 6: 82 thousand triangles with 0.30 mm; 8: a million with 0.15 mm.
void levels(benchmark::internal::Benchmark* b) {
  b->Arg(6)->Arg(8)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}
BENCHMARK(buildCharts)->Apply(levels);
BENCHMARK(check)->Apply(levels);
BENCHMARK(measure)->Apply(levels);
BENCHMARK(bake)->Apply(levels);
BENCHMARK(split)->Apply(levels);

}  // namespace
}  // namespace sonoskin
