#include "app/batch/batch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <new>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/batch/crash_message.h"
#include "app/document/face_view.h"
#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/mesh_encoders.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/recipe.h"
#include "render/pictures.h"
#include "render/skin/baked_maps.h"
#include "render/skin/skin_pictures.h"

namespace sonoskin {
namespace {

// Shares of the whole time, measured on the phantom at full size.
constexpr double kLoaded = 0.3, kComputed = 0.7, kChecked = 0.75, kWritten = 0.8, kDrawn = 0.98;

// BatchRun: what the steps of one run share.
//   parameters  those of the options, with the landmarks of the input
struct BatchRun {
  const BatchOptions& options;
  Parameters parameters;
  const Progress& progress;
  const Pipeline::StageBegins& stageBegins;
  OutputFolder folder;
  Report report;
  LogRecord said{};
  std::optional<TexturedMesh> baked{};

  std::filesystem::path file(const std::string& name) {
    report.files.push_back(name);
    return folder.file(name);
  }
  // stage: does one step and notes what it cost; `step` returns the bytes of its result.
  template <class Step>
  void stage(const std::string& name, Step&& step) {
    if (stageBegins) stageBegins(name);
    const Timer timer;
    const std::size_t bytes = step();
    report.stages.push_back({name, timer.seconds(), bytes});
  }
};

Scan load(BatchRun& run) {
  Scan scan;
  const bool phantom = run.options.input.volume == kPhantomInput;
  run.stage(phantom ? "simulation" : "reading", [&] {
    scan = loadInput(run.options.input, run.parameters, run.progress.part(0, kLoaded));
    return scan.volume->data.size() * sizeof(float);
  });
  run.report.input = run.options.inputName.empty() ? scan.key.hex() : run.options.inputName;
  const Geometry& g = scan.volume->geometry;
  run.report.dims = {g.dims.x, g.dims.y, g.dims.z};
  run.report.spacing = {g.spacing.x, g.spacing.y, g.spacing.z};
  run.report.spacingKnown = scan.spacingKnown;
  if (scan.erased)
    run.report.erasedVoxels = scan.erased->data.size() -
                              std::size_t(std::count(scan.erased->data.begin(), scan.erased->data.end(), 0));
  return scan;
}

Results compute(BatchRun& run, const Scan& scan) {
  Pipeline pipeline;  // gone after this, and with it what only a later run would need
  Results results =
      pipeline.run(scan, run.parameters, Goal::mesh, run.progress.part(kLoaded, kComputed), run.stageBegins);
  run.report.stages.insert(run.report.stages.end(), results.stages.begin(), results.stages.end());
  run.report.isoValue = results.isoValue;
  run.report.isoShare = run.parameters.classification.isoShare;
  run.report.isoRange = results.isoRange;
  for (const std::string& warning : results.warnings) log(LogLevel::warning, asSentence(warning));
  run.report.points = results.points->size();
  run.report.edge = results.edge;
  run.report.centres = results.centres;
  run.report.globalError = results.globalError;
  run.report.globalErrorWithWeights = results.globalErrorWithWeights;
  run.report.pieces = results.pieces->size();
  run.report.face = reportFace(results.face.get(), run.parameters.face);
  run.report.parts = reportParts(results);
  return results;
}

// What can be said of the meshes before they are printed.
void checkMeshes(BatchRun& run, const Results& results) {
  run.stage("checks", [&] {
    const Progress progress = run.progress.part(kComputed, kChecked);
    run.report.mesh = measureMesh(*results.mesh, progress.part(0, 0.5));
    run.report.measured = measureFilled(*results.mesh);
    if (results.print) run.report.print = measureMesh(*results.print, progress.part(0.5, 1));
    return std::size_t(0);
  });
}

// The finished picture of the skin, and its maps for files.
void drawSkin(BatchRun& run, gl::Context& context, const Results& results, const PictureOptions& frame,
              const Progress& progress) {
  const bool bakes = run.options.bake != Bake::none;
  const SkinPictureOptions look{.quality = run.options.skinQuality};
  Parameters parameters = run.parameters;  // the recipe keeps what was given by hand
  parameters.landmarks = landmarksWithFace(run.parameters, results.face.get());
  writePng(run.file("skin.png"),
           pictureOfSkin(context, results.mesh, parameters, look, frame, progress.part(0, bakes ? 0.5 : 1)));
  if (!bakes) return;
  const BakeOptions bake{run.options.skinQuality, run.options.bake == Bake::light};
  run.baked = bakeSkin(context, results.mesh, parameters, bake, frame, progress.part(0.5, 1));
}

// Before the face, upright, where one was found; else from the probe.
PictureOptions frameOf(const BatchRun& run, const Scan& scan, const Results& results) {
  const FaceFit* face = run.report.face.used ? results.face.get() : nullptr;
  PictureOptions frame;
  frame.size = run.options.pictureSize;
  frame.beam = beamOf(scan, run.parameters.scan);
  if (run.options.turnsFormat && isTall(results.mesh->positions, face, frame.beam))
    frame.size = {frame.size.y, frame.size.x};
  frame.camera = "face";
  frame.face =
      cameraOnFace(results.mesh->positions, face, frame.beam, float(frame.size.x) / float(frame.size.y));
  return frame;
}

void drawPictures(BatchRun& run, const Scan& scan, const Results& results) {
  run.stage("pictures", [&] {
    const auto context = gl::makeOffscreenContext(run.options.backend);
    run.report.gl = gl::glInfo();
    const PictureOptions frame = frameOf(run, scan, results);
    const Progress progress = run.progress.part(kWritten, kDrawn);
    drawSkin(run, *context, results, frame, progress.part(0, 0.4));
    VolumePictureOptions look;
    look.iso = float(results.visibleLevel);
    look.crop = boxAround(*results.mesh);
    writePng(run.file("mesh.png"), pictureOfMesh(*context, results.mesh, MeshLook::clay, frame));
    progress.update(0.5);
    const Region region = regionOf(scan, run.parameters.region);
    writePng(run.file("volume.png"),
             pictureOfVolume(*context, withinRegion(scan.volume, region), look, frame));
    progress.update(0.8);
    const SlicesInput slices{scan.volume, results.classified, results.thinned, middleOf(*results.mesh),
                             region};
    writePng(run.file("slices.png"), pictureOfSlices(*context, slices, run.options.pictureSize));
    return 4 * 4 * std::size_t(frame.size.x) * std::size_t(frame.size.y);
  });
}

void writePoints(const std::filesystem::path& path, const SurfacePoints& points) {
  Mesh cloud;
  cloud.positions = points.positions;
  cloud.normals = points.normals;
  const std::vector<std::uint8_t> bytes = encodePly(cloud);
  writeBytes(path, bytes.data(), bytes.size());
}

void writeSurfaces(BatchRun& run, const Results& results, const Progress& progress) {
  for (const std::string& format : run.options.meshFormats)
    writeMesh(run.file("mesh." + format), *results.mesh, progress);
}

// The surface with the maps of its skin.
void writeBaked(BatchRun& run, const Progress& progress) {
  if (!run.baked) return;
  for (const std::string& format : run.options.meshFormats) {
    if (!formatNamed(FileKind::texturedMesh, "skin." + format)) continue;
    const std::vector<std::string> files =
        writeTexturedMesh(run.folder.file("skin." + format), *run.baked, progress);
    run.report.files.insert(run.report.files.end(), files.begin(), files.end());
  }
}

std::size_t writeFiles(BatchRun& run, const Scan& scan, const Results& results) {
  const BatchOptions& options = run.options;
  const Progress progress = run.progress.part(kChecked, kWritten);
  writeSurfaces(run, results, progress.part(0, 0.2));
  if (results.print) writeMesh(run.file("print.stl"), *results.print, progress.part(0.2, 0.25));
  if (results.print && std::ranges::count(options.meshFormats, "3mf") > 0)
    writeMesh(run.file("print.3mf"), *results.print, progress.part(0.25, 0.3));
  if (options.input.volume == kPhantomInput)
    writeMesh(run.file("truth.ply"), makePhantomTruth(run.parameters.phantom, progress.part(0.3, 0.7)));
  if (options.keepClassified)
    writeVolume(run.file("classified.nrrd"), *results.classified, scan.beam, progress.part(0.7, 0.9));
  if (options.keepThinned)
    writeVolume(run.file("thinned.nrrd"), *results.thinned, scan.beam, progress.part(0.9, 0.95));
  if (options.keepPoints) writePoints(run.file("points.ply"), *results.points);
  const std::string recipe = writeRecipe(run.parameters, scan.key, scan.erased.get());
  writeBytes(run.file("recipe.json"), recipe.data(), recipe.size());
  progress.update(1);
  return 0;
}

// Files of an earlier run in the folder that this one has none of: its report names them. Nothing else is touched, whatever
// a report says.
std::vector<std::string> obsoleteFiles(const BatchRun& run) {
  static const std::regex kOurs(
      fmt::format(R"((skin|mesh|volume|slices)\.png|(mesh|skin|print)\.({}|mtl)|skin_\w+\.png|)"
                  R"(truth\.ply|points\.ply|(classified|thinned)\.nrrd)",
                  fmt::join(extensionWords(FileKind::writtenMesh), "|")));
  std::vector<std::string> obsolete;
  nlohmann::json earlier;
  try {
    earlier = nlohmann::json::parse(readText(run.options.folder / "report.json"), nullptr, false);
  } catch (const Error&) {
    return obsolete;  // there was no earlier run, or its report is none
  }
  if (!earlier.is_object() || !earlier.contains("files") || !earlier["files"].is_array()) return obsolete;
  for (const nlohmann::json& name : earlier["files"])
    if (name.is_string() && std::regex_match(name.get<std::string>(), kOurs) &&
        std::ranges::count(run.report.files, name.get<std::string>()) == 0)
      obsolete.push_back(name.get<std::string>());
  return obsolete;
}

// The report is written anew with each set of files.
void publish(BatchRun& run, const Timer& timer) {
  const std::string name = "report.json";
  if (std::ranges::count(run.report.files, name) == 0) run.report.files.push_back(name);
  run.report.seconds = timer.seconds();
  run.report.peakMemory = peakMemoryBytes();
  run.report.warnings = run.said.sentences(LogLevel::warning);
  run.report.notes = run.said.sentences(LogLevel::info);
  const std::string report = reportJson(run.report);
  writeBytes(run.folder.file(name), report.data(), report.size());
  run.progress.throwIfCancelled();
  run.folder.commit(obsoleteFiles(run));
}

// What was computed is safe by now. A renderer that has no memory may end the program without an exception.
void addPictures(BatchRun& run, const Scan& scan, const Results& results, const Timer& timer) {
  const CrashMessage message(
      "sonoskin: error: The pictures could not be drawn (memory may be short); the surface is written.\n");
  try {
    drawPictures(run, scan, results);
    writeBaked(run, run.progress.part(kDrawn, 1));
  } catch (const Error& error) {
    throw Error(fmt::format("The surface is written, but its pictures could not be drawn: {}", error.what()),
                Error::Kind::system);
  } catch (const std::bad_alloc&) {
    throw Error(
        "The surface is written, but its pictures could not be drawn for want of memory; close other "
        "programs or give a smaller --size.",
        Error::Kind::system);
  }
  publish(run, timer);
}

}  // namespace

Report runBatch(const BatchOptions& options, const Progress& progress,
                const Pipeline::StageBegins& stageBegins) {
  const Timer timer;
  BatchRun run{options,
               withLandmarks(options.parameters, options.input.volume),
               progress,
               stageBegins,
               OutputFolder(options.folder),
               {}};
  run.report.threads = threadCount();

  const Scan scan = load(run);
  const Results results = compute(run, scan);
  checkMeshes(run, results);
  run.stage("files", [&] { return writeFiles(run, scan, results); });
  publish(run, timer);
  addPictures(run, scan, results, timer);
  return run.report;
}

}  // namespace sonoskin
