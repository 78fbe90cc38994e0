// Light on skin without an atlas, beside the integral over the surface, for a ball of a face's area.
#include <benchmark/benchmark.h>

#include "core/skin/brute_force.h"
#include "core/skin/hierarchical_integral.h"
#include "core/skin/point_diffusion.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// 81,920 triangles, 13,700 mm^2.
const Mesh& ball() {
  static const Mesh mesh = test::icosphere(6, 33, glm::vec3(0));
  return mesh;
}

AreaPoints pointsOf(const SurfaceSamples& s) { return {s.positions, s.normals, s.areas}; }

std::vector<glm::vec3> litFromAbove(const SurfaceSamples& samples) {
  std::vector<glm::vec3> irradiance;
  for (const glm::vec3& n : samples.normals) irradiance.emplace_back(std::max(0.f, n.z));
  return irradiance;
}

std::vector<DiffusionTarget> someTargets(const SurfaceSamples& samples) {
  std::vector<DiffusionTarget> targets;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / 1000)
    targets.push_back({samples.positions[i], samples.normals[i], glm::vec3(0)});
  return targets;
}

void pointsBuilt(benchmark::State& state) {
  const AreaPoints points = pointsOf(sampleSurface(ball(), PointDiffusion::kBaseSpacing));
  for (auto _ : state) {
    const PointDiffusion diffusion(points, literatureSkin());
    state.counters["MB"] = double(diffusion.bytes()) / 1e6;
  }
}

// All levels at the 41,000 vertices.
void pointsLit(benchmark::State& state) {
  const AreaPoints points = pointsOf(sampleSurface(ball(), PointDiffusion::kBaseSpacing));
  const PointDiffusion diffusion(points, literatureSkin());
  const DiffusionPlaces places = inLocalOrder(ball().positions, ball().normals);
  const std::vector<glm::vec4> irradiance(points.size(), glm::vec4(1));
  for (auto _ : state) {
    const PointDiffusion::Levels gathered = diffusion.gather(irradiance);
    for (int level = 1; level <= PointDiffusion::kLevels; ++level)
      benchmark::DoNotOptimize(diffusion.lightAt(level, gathered[std::size_t(level - 1)], places));
  }
}

// 1000 places: per place it is a thousandth.
void octree(benchmark::State& state) {
  const SurfaceSamples samples = sampleSurface(ball(), 0.15);
  const HierarchicalIntegral integral(samples, litFromAbove(samples));
  const RadialProfile profile = profileOf(literatureSkin(), 1);
  const std::vector<DiffusionTarget> targets = someTargets(samples);
  for (auto _ : state)
    for (const DiffusionTarget& t : targets)
      benchmark::DoNotOptimize(integral.at(t.position, t.normal, profile, {0.01 * double(state.range(0))}));
}

void bruteForce(benchmark::State& state) {
  const SurfaceSamples samples = sampleSurface(ball(), 0.11);
  const std::vector<glm::vec3> irradiance = litFromAbove(samples);
  const std::vector<DiffusionTarget> targets = someTargets(samples);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        bruteForceDiffusion(samples, irradiance, literatureSkin(), targets, Reach::full));
}

BENCHMARK(pointsBuilt)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(pointsLit)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(octree)->Arg(5)->Arg(10)->Arg(30)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(bruteForce)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace sonoskin
