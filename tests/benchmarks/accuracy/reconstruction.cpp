#include "tests/benchmarks/accuracy/reconstruction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "core/mesh/search/mesh_distance.h"
#include "core/rbf/surface/iso_surface.h"
#include "tests/benchmarks/accuracy/clouds.h"
#include "tests/benchmarks/accuracy/levels.h"

namespace sonoskin::accuracy {
namespace {

constexpr int kResolution = 300;  // cells; finer ones change the figures by less than 0.001 mm

struct Variant {
  std::string name;
  bool refined = true;
  ReconstructionOptions options;
};

// The defaults and what differs from them in one respect, all combinations of the three switches, and the smoothness.
std::vector<Variant> variants(const ReconstructionOptions& defaults) {
  std::vector<Variant> all;
  for (const bool weights : {false, true})
    for (const bool refined : {true, false})
      for (const bool confidence : {true, false}) {
        ReconstructionOptions o = defaults;
        o.fitWeights = weights;
        o.confidence = confidence;
        all.push_back(
            {fmt::format("{:g}, {}, {}, {}", o.smoothness, refined ? "sub-voxel" : "whole voxels",
                         confidence ? "confidence" : "all alike", weights ? "weights" : "no weights"),
             refined, o});
      }
  for (const double smoothness : {1e-5, 2e-5, 5e-5, 7e-5, 1e-4, 1.4e-4, 2e-4})
    for (const bool weights : {false, true}) {
      if (smoothness == defaults.smoothness) continue;
      ReconstructionOptions o = defaults;
      o.smoothness = smoothness;
      o.fitWeights = weights;
      all.push_back({fmt::format("{:g}{}", smoothness, weights ? ", weights" : ""), true, o});
    }
  ReconstructionOptions thesis = defaults;
  thesis.method = ReconstructionMethod::thesis;
  all.push_back({fmt::format("{:g}, method thesis", thesis.smoothness), true, thesis});
  return all;
}

std::string row(const Variant& variant, const Cloud& cloud, MeshOptions mesh) {
  const SurfacePoints& points = variant.refined ? cloud.refined : cloud.rounded;
  const CsrbfModel model = fitCsrbf(points, variant.options);
  mesh.resolution = kResolution;
  const Mesh surface = extractIsoSurface(model, points, mesh);
  const MeshDistances d = measureDistances(surface, cloud.truth);
  const DistanceStatistics& there = d.visibleAToB;
  return fmt::format("| {} | {} | {:.3f} | {:.3f} | {:.2f} | {:+.3f} | {:.2f} | {:.3f} |\n", variant.name,
                     model.centres().size(), there.rms, there.p95, there.max, there.signedMedian,
                     there.normalAngle, d.visibleBToA.p95);
}

void print(const Cloud& cloud, const Parameters& parameters) {
  std::printf("### %s: %zu points\n\n%s", cloud.name.c_str(), cloud.refined.size(),
              "| fit | centres | RMS mm | p95 mm | max mm | median mm | normals | back p95 mm |\n"
              "|---|---|---|---|---|---|---|---|\n");
  for (const Variant& variant : variants(parameters.reconstruction)) {
    std::printf("%s", row(variant, cloud, parameters.mesh).c_str());
    std::fflush(stdout);
  }
  std::printf("\n");
}

}  // namespace

void printReconstructionTables(const Parameters& parameters) {
  for (const Level& level : noiseLevels())
    if (level.name == "A" || level.name == "C" || level.name == "E")
      print(phantomCloud(level.name, level.snr, parameters), parameters);
  for (const double jitter : {0.0, 0.5}) print(sphereCloud(jitter), parameters);
}

}  // namespace sonoskin::accuracy
