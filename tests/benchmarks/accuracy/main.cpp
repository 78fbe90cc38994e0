// sonoskin_accuracy: how well each way from a volume to points finds the skin of the simulated baby, at five noise
// levels. Prints Markdown; tests/benchmarks/README.md explains the columns and holds the last run.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/benchmarks/accuracy/faces.h"
#include "tests/benchmarks/accuracy/levels.h"
#include "tests/benchmarks/accuracy/methods.h"
#include "tests/benchmarks/accuracy/reconstruction.h"
#include "tests/benchmarks/accuracy/report.h"
#include "tests/benchmarks/accuracy/settings.h"
#include "tests/benchmarks/accuracy/skin.h"

namespace sonoskin::accuracy {
namespace {

struct Request {
  Given given;
  FacesOptions faces;
  std::vector<std::string> levels, methods;
  std::string sweep;
  int threads = 0;
  bool lines = false, reconstruction = false, skin = false, isFaces = false;
};

std::vector<Method> allMethods() {
  std::vector<Method> all = ownMethods();
  for (const auto& more : {rivals(), itkRivals()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

Request parse(int argc, char** argv) {
  Request request;
  CLI::App app{"Precision, recall and residuals of the surface points on the simulated scan, as Markdown."};
  std::string names;
  for (const Method& m : allMethods()) names += (names.empty() ? "" : ", ") + m.name;
  app.add_option("--dims", request.given.dims, "voxels of the simulated scan")->expected(3)->delimiter('x');
  app.add_option("--levels", request.levels, "some of A,B,C,D,E; all by default")->delimiter(',');
  app.add_option("--methods", request.methods, "some of " + names + "; all by default")->delimiter(',');
  app.add_option("--set", request.given.sets,
                 "a parameter of the recipe: group.field=value; may be repeated");
  app.add_option("--sweep", request.sweep, "one row for each value: group.field=value,value,...");
  app.add_option("--seed", request.given.seed, "of the speckle");
  app.add_option("--threads", request.threads, "0: all of the machine");
  app.add_flag("--reconstruction", request.reconstruction, "meshes instead of points: RMS, normals and more");
  app.add_flag("--skin", request.skin, "the light of skin against the integral over the surface");
  app.add_flag("--faces", request.isFaces, "the whole program's meshes over scenes, shapes and seeds");
  addOptions(app, request.faces);
  app.add_flag("--lines", request.lines, "key=value lines instead of tables");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return request;
}

bool wanted(const std::vector<std::string>& list, const std::string& name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

void requireKnown(const Request& request) {
  const auto methods = allMethods();
  for (const std::string& name : request.methods)
    require(std::any_of(methods.begin(), methods.end(), [&](const Method& m) { return m.name == name; }),
            "{}: no such method; --help lists them", name);
  for (const std::string& name : request.levels)
    require(std::any_of(noiseLevels().begin(), noiseLevels().end(),
                        [&](const Level& l) { return l.name == name; }),
            "{}: no such level; there are A, B, C, D and E", name);
}

// One method with one recipe.
Row runMethod(const Method& method, const Scan& scan, const Parameters& parameters, const Truth& truth) {
  Row row;
  row.method = method.name;
  row.help = method.help;
  const std::clock_t start = std::clock();
  const Finding finding = method.find(scan, parameters);
  row.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  row.isoValue = finding.isoValue;
  row.score = scorePoints(finding.points, truth);
  return row;
}

std::vector<Row> runLevel(const Request& request, const Level& level, const Truth& truth,
                          const ContrastMeter& meter, Parameters parameters) {
  parameters.phantom.snr = level.snr;
  const Scan scan = makePhantomScan(parameters.phantom);
  const double contrast = meter.measure(*scan.volume);
  std::vector<Setting> sweep;
  if (!request.sweep.empty()) sweep = parseSettings(request.sweep);
  std::vector<Row> rows;
  for (const Method& method : allMethods()) {
    if (!wanted(request.methods, method.name)) continue;
    for (std::size_t s = 0; s < std::max<std::size_t>(1, sweep.size()); ++s) {
      Parameters changed = parameters;
      if (!sweep.empty()) apply(sweep[s], changed);
      Row row = runMethod(method, scan, changed, truth);
      if (!sweep.empty()) row.settings = sweep[s].name + "=" + sweep[s].value;
      row.level = level.name, row.snr = level.snr, row.contrast = contrast;
      if (request.lines) std::printf("%s\n", machineLine(row).c_str());
      std::fflush(stdout);
      rows.push_back(row);
    }
  }
  return rows;
}

void runAll(const Request& request) {
  requireKnown(request);
  setThreadCount(request.threads);
  if (request.isFaces) return printFaceTables(request.faces, request.given, request.sweep);
  const Parameters parameters = parametersOf(request.given);
  if (request.reconstruction) return printReconstructionTables(parameters);
  if (request.skin) return printSkinTables(parameters);
  require(!request.given.names("phantom.snr"), "phantom.snr: the levels set it; choose some with --levels");
  const Truth truth(parameters.phantom);
  const ContrastMeter meter(parameters.phantom);
  std::vector<Row> all;
  for (const Level& level : noiseLevels()) {
    if (!wanted(request.levels, level.name)) continue;
    const std::vector<Row> rows = runLevel(request, level, truth, meter, parameters);
    if (!request.lines && !rows.empty()) std::printf("%s\n", levelTable(rows).c_str());
    std::fflush(stdout);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  if (!request.lines && !all.empty())
    std::printf("### F at 1.5 voxels (at 3 voxels), debiased\n\n%s", summaryTable(all).c_str());
}

}  // namespace
}  // namespace sonoskin::accuracy

int main(int argc, char** argv) {
  try {
    sonoskin::accuracy::runAll(sonoskin::accuracy::parse(argc, argv));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonoskin_accuracy: error: %s\n", error.what());
    return 1;
  }
}
