#include "app/batch/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/batch/film.h"
#include "app/batch/obsolete_files.h"
#include "app/batch/picture_frame.h"
#include "app/batch/picture_writer.h"
#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/base/timer.h"
#include "core/io/atomic_file.h"
#include "core/io/mesh_writer.h"
#include "core/pipeline/recipe.h"
#include "render/skin/skin_pictures.h"

namespace sonoskin {
namespace {

constexpr double kSurfaces = 0.95;                // share of the time; the rest is the film
constexpr double kLeastRate = 1, kMostRate = 30;  // pictures per second
constexpr double kRate = 10;                      // where the file does not tell

// SequenceRun: what the steps share.
struct SequenceRun {
  const BatchOptions& options;
  OutputFolder folder;
  std::unique_ptr<gl::Context> context;
  SequenceReport report{};
  std::vector<std::filesystem::path> pictures{};
  std::optional<PictureOptions> frame{};  // of the first step, so that the face moves and not the camera
  std::string recipe{};
  LogRecord said{};

  std::filesystem::path file(const std::string& name) {
    report.files.push_back(name);
    return folder.file(name);
  }
};

void note(SequenceRun& run, const StepSurface& step) {
  const Results& results = step.results;
  for (const std::string& warning : results.warnings)
    log(LogLevel::warning, fmt::format("Time step {}: {}", step.time, asSentence(warning)));
  run.report.timeSteps = step.scan.timeSteps;
  run.report.stepSeconds = step.scan.stepSeconds;
  if (run.report.input.empty())
    run.report.input = run.options.inputName.empty() ? step.scan.key.hex() : run.options.inputName;
  run.report.steps.push_back({step.time, results.points->size(), results.mesh->triangles.size(),
                              surfaceArea(*results.mesh), results.isoValue,
                              reportFace(results.face.get(), run.options.parameters.face)});
}

void draw(SequenceRun& run, const StepSurface& step, const Progress& progress) {
  const BatchOptions& o = run.options;
  const Results& results = step.results;
  const FaceFit* face = run.report.steps.back().face.used ? results.face.get() : nullptr;
  if (!run.frame)
    run.frame =
        pictureFrame(*results.mesh, face, beamOf(step.scan, o.parameters.scan), o.pictureSize, o.turnsFormat);
  Parameters parameters = o.parameters;
  parameters.landmarks = landmarksWithFace(o.parameters, results.face.get());
  const Image picture =
      pictureOfSkin(*run.context, results.mesh, parameters, {.quality = o.skinQuality}, *run.frame, progress);
  run.pictures.push_back(run.file(fmt::format("skin_{:04}.png", step.time)));
  writePng(run.pictures.back(), picture);
}

void take(SequenceRun& run, const StepSurface& step, const Progress& progress) {
  note(run, step);
  for (const std::string& format : run.options.meshFormats)
    writeMesh(run.file(fmt::format("mesh_{:04}.{}", step.time, format)), *step.results.mesh,
              run.options.meshFile, progress.part(0, 0.2));
  if (run.recipe.empty())
    run.recipe = writeRecipe(run.options.parameters, step.scan.key, step.scan.erased.get());
  draw(run, step, progress.part(0.2, 1));
}

void addFilm(SequenceRun& run, const Progress& progress) {
  const double told = run.report.stepSeconds;
  const double rate = told > 0 ? std::clamp(1 / told, kLeastRate, kMostRate) : kRate;
  if (makeFilm(run.pictures, rate, run.folder.file("film.mp4"), progress))
    run.report.files.push_back("film.mp4");
  else
    log(LogLevel::info, "No film was made of the pictures: that needs the program ffmpeg.");
}

void publish(SequenceRun& run, const Timer& timer) {
  writeBytes(run.file("recipe.json"), run.recipe.data(), run.recipe.size());
  const std::filesystem::path file = run.file("report.json");
  run.report.warnings = run.said.sentences(LogLevel::warning);
  run.report.notes = run.said.sentences(LogLevel::info);
  run.report.seconds = timer.seconds();
  const std::string report = sequenceJson(run.report);
  writeBytes(file, report.data(), report.size());
  run.folder.commit(obsoleteFiles(run.options.folder, run.report.files));
}

}  // namespace

SequenceReport runSequence(const BatchOptions& options, StepRange steps, const Progress& progress,
                           const Pipeline::StageBegins& stageBegins) {
  const Timer timer;
  SequenceRun run{options, OutputFolder(options.folder), gl::makeOffscreenContext(options.backend)};
  if (stageBegins) stageBegins("surfaces");
  const auto load = [parameters = options.parameters, &options](int time, const Progress& part) mutable {
    parameters.scan.time = time;
    return loadInput(options.input, parameters, part);
  };
  run.report.missing = makeSurfaces(
      load, options.parameters, steps,
      [&run](const StepSurface& step, const Progress& part) { take(run, step, part); },
      progress.part(0, kSurfaces));
  if (stageBegins) stageBegins("film");
  addFilm(run, progress.part(kSurfaces, 1));
  publish(run, timer);
  progress.update(1);
  return run.report;
}

}  // namespace sonoskin
