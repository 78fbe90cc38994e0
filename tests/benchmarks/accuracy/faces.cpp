#include "tests/benchmarks/accuracy/faces.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/timer.h"
#include "core/face/face_fit.h"
#include "core/io/atomic_file.h"
#include "core/io/mesh_encoders.h"
#include "core/io/mesh_reader.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/prepared.h"
#include "tests/benchmarks/accuracy/faces_pose.h"
#include "tests/benchmarks/accuracy/faces_table.h"

namespace sonoskin::accuracy {
namespace {

namespace fs = std::filesystem;

constexpr double kFluidShare = 0.5;  // darker than halfway from the fluid to the edges is fluid

// Case: one simulated baby, with the parameters of its runs: one for each setting of a sweep.
struct Case {
  std::string scene;
  Parameters parameters;
  std::vector<Setting> settings;

  std::string name() const {
    return fmt::format("{}-{}-{}", scene, parameters.phantom.shape, parameters.phantom.seed);
  }
};

// A value of a sweep marks the files that it leads to.
std::string fileOf(const Case& one, const Setting& setting) {
  return one.name() + (setting.name.empty() ? "" : "-" + setting.value) + ".ply";
}

std::vector<std::string> everyScene() {
  std::vector<std::string> names;
  for (const char* name : enumNames(PhantomScene{})) names.emplace_back(name);
  return names;
}

template <class T>
std::vector<T> chosen(const std::vector<T>& asked, bool isSet, const T& set,
                      const std::vector<T>& otherwise) {
  if (!asked.empty()) return asked;
  return isSet ? std::vector<T>{set} : otherwise;
}

std::vector<Case> casesOf(const FacesOptions& options, const Given& given) {
  const Parameters base = parametersOf(given);
  const PhantomOptions& set = base.phantom;
  const auto scenes = chosen<std::string>(options.scenes, given.names("phantom.scene"),
                                          enumNames(set.scene)[std::size_t(set.scene)], everyScene());
  const auto shapes = chosen(options.shapes, given.names("phantom.shape"), set.shape, {0, 1, 2, 3, 4});
  const auto seeds =
      chosen(options.seeds, given.seed || given.names("phantom.seed"), set.seed, std::vector<int>{1, 2});
  std::vector<Case> cases;
  for (const std::string& scene : scenes)
    for (const int shape : shapes)
      for (const int seed : seeds) {
        Case next{scene, base, {}};
        apply({"phantom.scene", scene}, next.parameters);
        if (given.dims.empty() && !given.names("phantom.dims")) next.parameters.phantom.dims = {256, 144, 72};
        next.parameters.phantom.shape = shape, next.parameters.phantom.seed = seed;
        cases.push_back(next);
      }
  return cases;
}

// withSweep: the settings belong to each case, unless they change the simulation: then each makes a case of its own.
std::vector<Case> withSweep(const std::vector<Case>& cases, const std::string& sweep) {
  const std::vector<Setting> settings = sweep.empty() ? std::vector<Setting>{{}} : parseSettings(sweep);
  std::vector<Case> result;
  for (Case one : cases) {
    one.settings = settings;
    if (!sweep.starts_with("phantom.")) {
      result.push_back(one);
      continue;
    }
    for (const Setting& setting : settings) {
      Case changed = one;
      apply(setting, changed.parameters);
      changed.settings = {setting};
      result.push_back(changed);
    }
  }
  return result;
}

void makeFolders(const FacesOptions& options) {
  for (const std::string& folder : {options.exportTo, options.pointsTo, options.keepTo})
    if (!folder.empty()) fs::create_directories(folder);
}

void writePoints(const fs::path& path, const SurfacePoints& points) {
  Mesh cloud;
  cloud.positions = points.positions;
  cloud.normals = points.normals;
  const std::vector<std::uint8_t> bytes = encodePly(cloud);
  writeBytes(path, bytes.data(), bytes.size());
}

// findFace: looks for the face among the points of the surface, and judges what was found.
void findFace(const Scan& scan, const Parameters& parameters, const SurfacePoints& points,
              const FaceTruth& truth, FaceScore& score) {
  const Prepared prepared = prepare(scan, *scan.volume, parameters);
  const FaceInput input{points, &prepared.smoothed.lowPassed, prepared.smoothed.levels.between(kFluidShare),
                        prepared.beam};
  const FaceFit fit = fitFace(input);
  score.confidence = double(fit.confidence);
  if (fit.confidence <= 0) return;
  const HeadPlaces& p = fit.places;
  const FacePose found{{p.rightEye, p.leftEye, p.noseTip, p.mouthRight, p.mouthLeft}, fit.up, fit.front};
  comparePose(found, truth.pose(), double(fit.confidence), score);
}

// FaceBench: judges one case after another.
class FaceBench {
 public:
  explicit FaceBench(const FacesOptions& options) : options_(options) {}

  void judge(const Case& one) {
    const FaceTruth truth(makePhantomTruth(one.parameters.phantom), phantomAnatomy(one.parameters.phantom));
    if (!options_.meshesFrom.empty()) {
      const Mesh mesh = readMesh(fs::path(options_.meshesFrom) / (one.name() + ".ply"));
      return keep(one, one.settings.front(), scoreFace(mesh, truth));
    }
    const Scan scan = makePhantomScan(one.parameters.phantom);
    if (!options_.exportTo.empty()) {
      writeScan(fs::path(options_.exportTo) / (one.name() + ".nrrd"), scan);
      writeMesh(fs::path(options_.exportTo) / (one.name() + "-truth.ply"), truth.skin());
    }
    Pipeline pipeline;
    for (const Setting& setting : one.settings) {
      Parameters parameters = one.parameters;
      if (!setting.name.empty()) apply(setting, parameters);
      keep(one, setting, run(pipeline, scan, parameters, truth, fileOf(one, setting)));
    }
  }

  const std::vector<FaceRow>& rows() const { return rows_; }

 private:
  FaceScore run(Pipeline& pipeline, const Scan& scan, const Parameters& parameters, const FaceTruth& truth,
                const std::string& file) const {
    const std::clock_t cpu = std::clock();
    const Timer timer;
    try {
      const Results results = pipeline.run(scan, parameters, Goal::mesh);
      const double seconds = double(std::clock() - cpu) / CLOCKS_PER_SEC, wall = timer.seconds();
      FaceScore score = scoreFace(*results.mesh, truth);
      score.cpuSeconds = seconds, score.wallSeconds = wall;
      findFace(scan, parameters, *results.points, truth, score);
      if (!options_.pointsTo.empty()) writePoints(fs::path(options_.pointsTo) / file, *results.points);
      if (!options_.keepTo.empty()) writeMesh(fs::path(options_.keepTo) / file, *results.mesh);
      return score;
    } catch (const Error& error) {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), error.what());
      return {};
    }
  }

  void keep(const Case& one, const Setting& setting, const FaceScore& score) {
    const std::string settings = setting.name.empty() ? "" : setting.name + "=" + setting.value;
    rows_.push_back({one.scene, settings, one.parameters.phantom.shape, one.parameters.phantom.seed, score});
  }

  const FacesOptions& options_;
  std::vector<FaceRow> rows_;
};

}  // namespace

void addOptions(CLI::App& app, FacesOptions& options) {
  app.add_option("--scenes", options.scenes, "with --faces: some scenes of the phantom; all by default")
      ->delimiter(',');
  app.add_option("--shapes", options.shapes, "with --faces: of the head; 0,1,2,3,4 by default")
      ->delimiter(',');
  app.add_option("--seeds", options.seeds, "with --faces: of the speckle; 1,2 by default")->delimiter(',');
  app.add_option("--csv", options.csv, "with --faces: a file for one line for each run");
  app.add_option("--export", options.exportTo, "with --faces: a folder for volumes and truth");
  app.add_option("--points", options.pointsTo, "with --faces: a folder for the points of the surface");
  app.add_option("--keep", options.keepTo, "with --faces: a folder for the meshes");
  app.add_option("--meshes", options.meshesFrom, "with --faces: a folder of others' meshes to judge");
}

void printFaceTables(const FacesOptions& options, const Given& given, const std::string& sweep) {
  const std::vector<Case> cases = withSweep(casesOf(options, given), sweep);
  makeFolders(options);
  FaceBench bench(options);
  for (const Case& one : cases) {
    bench.judge(one);
    if (options.csv.empty()) continue;
    const std::string csv =
        faceCsv(bench.rows());  // after each case, so that a run that is stopped has said something
    writeBytes(options.csv, csv.data(), csv.size());
  }
  std::printf("%s", faceTables(bench.rows()).c_str());
}

}  // namespace sonoskin::accuracy
