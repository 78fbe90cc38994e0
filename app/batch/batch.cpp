#include "app/batch/batch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <new>
#include <utility>

#include "app/batch/crash_message.h"
#include "app/batch/obsolete_files.h"
#include "app/batch/picture_frame.h"
#include "app/batch/picture_writer.h"
#include "app/batch/report_parts.h"
#include "app/batch/waiting_picture.h"
#include "app/document/points_file.h"
#include "app/document/view_planes.h"
#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
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
    noteTimeSteps(scan);
    return scan.volume->data.size() * sizeof(float);
  });
  run.report.input = run.options.inputName.empty() ? scan.key.hex() : run.options.inputName;
  reportScan(run.report, scan);
  run.report.measures = measuresOf(run.options.input, scan);
  return scan;
}

Results compute(BatchRun& run, const Scan& scan) {
  Pipeline pipeline;  // gone after this, and with it what only a later run would need
  Results results =
      pipeline.run(scan, run.parameters, Goal::mesh, run.progress.part(kLoaded, kComputed), run.stageBegins);
  reportResults(run.report, results, run.parameters);
  for (const std::string& warning : results.warnings) log(LogLevel::warning, asSentence(warning));
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

PictureOptions frameOf(const BatchRun& run, const Scan& scan, const Results& results) {
  const FaceFit* face = run.report.face.used ? results.face.get() : nullptr;
  return pictureFrame(*results.mesh, face, beamOf(scan, run.parameters.scan), run.options.pictureSize,
                      run.options.turnsFormat);
}

// SkinShot: what the picture of the skin and its maps are made from.
struct SkinShot {
  std::shared_ptr<const Mesh> mesh;
  Parameters parameters;
  PictureOptions frame;
};

SkinShot skinShot(const BatchRun& run, const Scan& scan, const Results& results) {
  SkinShot shot{results.mesh, run.parameters, frameOf(run, scan, results)};
  // The recipe keeps what was given by hand.
  shot.parameters.landmarks = landmarksWithFace(run.parameters, results.face.get());
  return shot;
}

Image drawSkin(gl::Context& context, const SkinShot& shot, const SkinQuality& quality,
               const Progress& progress) {
  return pictureOfSkin(context, shot.mesh, shot.parameters, {.quality = quality}, shot.frame, progress);
}

// Slices and volume, whose memory is given back behind them; what comes later needs the mesh alone.
void drawScan(BatchRun& run, gl::Context& context, Scan& scan, Results& results, const PictureOptions& frame,
              PictureWriter& writer) {
  const Region region = regionOf(scan, run.parameters.region);
  const PlaneAxes planes =
      planeAxes(scan.volume->geometry, viewFrameOf(scan, beamOf(scan, run.parameters.scan)));
  writer.write(run.folder.file("slices.png"),
               pictureOfSlices(context,
                               {scan.volume, std::exchange(results.classified, {}),
                                std::exchange(results.thinned, {}), middleOf(*results.mesh), region, planes},
                               run.options.pictureSize));
  VolumePictureOptions look;
  look.iso = float(results.visibleLevel);
  look.crop = boxAround(*results.mesh);
  writer.write(run.folder.file("volume.png"),
               pictureOfVolume(context, withinRegion(std::exchange(scan.volume, {}), region), look, frame));
}

// The skin is drawn last: it takes the most memory, and was being prepared meanwhile.
void drawPictures(BatchRun& run, Scan scan, Results results, WaitingPicture& skin, const SkinShot& shot) {
  run.stage("pictures", [&] {
    const auto context = gl::makeOffscreenContext(run.options.backend);
    run.report.gl = gl::glInfo();
    for (const char* name : {"skin.png", "mesh.png", "volume.png", "slices.png"})
      run.report.files.push_back(name);
    const Progress progress = run.progress.part(kWritten, kDrawn);
    PictureWriter writer;
    drawScan(run, *context, scan, results, shot.frame, writer);
    progress.update(0.3);
    results = {};  // parts, pieces, points: what is left needs the mesh alone
    writer.write(run.folder.file("mesh.png"), pictureOfMesh(*context, shot.mesh, MeshLook::clay, shot.frame));
    progress.update(0.5);
    const bool bakes = run.options.bake != Bake::none;
    writer.write(run.folder.file("skin.png"), skin.take(*context, progress.part(0.5, bakes ? 0.7 : 1)));
    if (bakes)
      run.baked = bakeSkin(*context, shot.mesh, shot.parameters,
                           {run.options.skinQuality, run.options.bake == Bake::light}, shot.frame,
                           progress.part(0.7, 1));
    writer.finish();
    return 4 * 4 * std::size_t(shot.frame.size.x) * std::size_t(shot.frame.size.y);
  });
}

void writeSurfaces(BatchRun& run, const Results& results, const Progress& progress) {
  for (const std::string& format : run.options.meshFormats)
    writeMesh(run.file("mesh." + format), *results.mesh, run.options.meshFile, progress);
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

// What other programs may want to see: the scan as it was read and taken, what was scanned of it, and what came of it.
void writeVolumes(BatchRun& run, const Scan& scan, const Results& results, const Progress& progress) {
  const BatchOptions& options = run.options;
  const auto file = [&](const std::string& name) { return run.file(name + "." + options.volumeFormat); };
  if (options.keepScan) writeScan(file("scan"), scan, progress.part(0, 0.3));
  if (options.keepScan && scan.mask)
    writeVolume(file("scan_mask"), *scan.mask, scan.beam, progress.part(0.3, 0.4));
  if (options.keepClassified)
    writeVolume(file("classified"), *results.classified, scan.beam, progress.part(0.4, 0.7));
  if (options.keepThinned) writeVolume(file("thinned"), *results.thinned, scan.beam, progress.part(0.7, 1));
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
  writeVolumes(run, scan, results, progress.part(0.7, 0.95));
  if (options.keepPoints) writePoints(run.file("points.ply"), *results.points);
  const std::string recipe = writeRecipe(run.parameters, scan.key, scan.erased.get());
  writeBytes(run.file("recipe.json"), recipe.data(), recipe.size());
  progress.update(1);
  return 0;
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
  run.folder.commit(obsoleteFiles(run.options.folder, run.report.files));
}

// What was computed is safe by now. A renderer that has no memory may end the program without an exception.
template <class Draw>
void addPictures(BatchRun& run, const Timer& timer, const Draw& draw) {
  const CrashMessage message(
      "sonoskin: error: The pictures could not be drawn (memory may be short); the surface is written.\n");
  try {
    draw();
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

  Scan scan = load(run);
  Results results = compute(run, scan);
  const SkinShot shot = skinShot(run, scan, results);
  WaitingPicture skin([&](gl::Context& context, const Progress& part) {
    return drawSkin(context, shot, options.skinQuality, part);
  });
  checkMeshes(run, results);
  run.stage("files", [&] { return writeFiles(run, scan, results); });
  publish(run, timer);
  addPictures(run, timer, [&] { drawPictures(run, std::move(scan), std::move(results), skin, shot); });
  return run.report;
}

}  // namespace sonoskin
