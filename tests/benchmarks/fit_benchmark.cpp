// The fit of the implicit function to the points: what is asked of it (113,000 points in 0.40 s and 362,000 in 0.95 s of
// wall time on two quiet cores, weights included), and a floor.
#include <benchmark/benchmark.h>

#include <nanoflann.hpp>

#include "core/rbf/csrbf_model.h"
#include "tests/benchmarks/point_input.h"

namespace sonoskin {
namespace {

enum Cloud { scan, relaxedScan, skin113, skin362 };

const SurfacePoints& cloudOf(std::int64_t cloud) {
  static const SurfacePoints small = skinPoints(113000), large = skinPoints(362000);
  switch (cloud) {
    case scan:
      return scanPoints();
    case relaxedScan:
      return relaxedScanPoints();
    case skin113:
      return small;
    default:
      return large;
  }
}

void fit(benchmark::State& state) {
  const SurfacePoints& points = cloudOf(state.range(0));  // made before the clock starts
  ReconstructionOptions options;
  options.smoothness = 2e-5;
  options.fitWeights = state.range(1) != 0;
  CsrbfModel model;
  for (auto _ : state) model = fitCsrbf(points, options);
  state.counters["points"] = double(points.size());
  state.counters["centres"] = double(model.centres().size());
  state.counters["globalError"] = model.report().globalErrorWithWeights.value_or(model.report().globalError);
}
BENCHMARK(fit)
    ->ArgNames({"cloud", "weights"})
    ->ArgsProduct({{scan, relaxedScan, skin113, skin362}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// A floor for the fit: the ten nearest neighbours of every point, as nanoflann finds them on one thread.
struct PointCloud {
  const std::vector<glm::vec3>& positions;
  std::size_t kdtree_get_point_count() const { return positions.size(); }
  float kdtree_get_pt(std::size_t point, std::size_t axis) const { return positions[point][int(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

void neighboursByNanoflann(benchmark::State& state) {
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointCloud>, PointCloud, 3>;
  const PointCloud cloud{scanPoints().positions};
  for (auto _ : state) {
    const Tree tree(3, cloud);
    std::uint32_t index[11];
    float squared[11], sum = 0;
    for (const glm::vec3& p : cloud.positions) {
      tree.knnSearch(&p[0], 11, index, squared);
      sum += squared[10];
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(neighboursByNanoflann)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sonoskin
