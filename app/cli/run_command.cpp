#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/batch/sequence.h"
#include "app/cli/choices.h"
#include "app/cli/commands.h"
#include "app/cli/mask_options.h"
#include "app/cli/parameter_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/skin_options.h"
#include "core/base/error.h"
#include "core/io/file_formats.h"

namespace sonoskin {
namespace {

struct RunOptions {
  BatchOptions batch;
  ParameterOptions parameters;
  std::vector<std::string> keep;
  std::optional<StepRange> time;
};

// Whether several time steps are asked for; one alone is a parameter.
bool isSequence(RunOptions& options) {
  if (!options.time) return false;
  options.batch.parameters.scan.time = options.time->first;
  return !options.time->isOne();
}

// Results on the way, baked maps and solids to print are of one surface.
void refuseForSequences(const RunOptions& options) {
  const BatchOptions& batch = options.batch;
  if (!options.keep.empty() || batch.bake != Bake::none || batch.parameters.print.form != PrintForm::none)
    throw Error("--keep, --bake and print.form are for one time step; name one with --time.",
                Error::Kind::usage);
}

void run(RunOptions& options, Console& console) {
  BatchOptions& batch = options.batch;
  batch.parameters = options.parameters.resolve(batch.input.recipe);
  const bool canBake = std::ranges::any_of(batch.meshFormats, [](const std::string& format) {
    return formatNamed(FileKind::texturedMesh, "mesh." + format).has_value();
  });
  if (batch.bake != Bake::none && !canBake)
    throw Error(fmt::format("--bake needs a format that holds pictures; let --export name {}.",
                            fmt::join(extensionWords(FileKind::texturedMesh), " or ")),
                Error::Kind::usage);
  const auto keeps = [&](const char* name) { return std::ranges::count(options.keep, name) > 0; };
  batch.inputName = console.nameOf(batch.input.volume);
  const auto stage = [&](const std::string& name) { console.beginStage(name); };
  if (isSequence(options)) {
    refuseForSequences(options);
    const SequenceReport report = runSequence(batch, *options.time, console.progress(), stage);
    return console.print(sequenceJson(report), sequenceText(report, batch.folder));
  }
  batch.keepClassified = keeps("classified");
  batch.keepThinned = keeps("thinned");
  batch.keepPoints = keeps("points");
  const Report report = runBatch(batch, console.progress(), stage);
  console.print(reportJson(report), reportText(report, batch.folder));
}

}  // namespace

Command addRunCommand(CLI::App& program, Console& console) {
  auto options = std::make_shared<RunOptions>();
  BatchOptions& batch = options->batch;
  CLI::App* command =
      program.add_subcommand("run", "volume -> mesh, pictures, recipe, report; no window needed");
  command->add_option("INPUT", batch.input.volume, "volume file, or \"phantom\" for the simulated scan")
      ->required()
      ->type_name("");
  command->add_option("--out", batch.folder, "folder for the results; made where missing")
      ->required()
      ->type_name("DIR");
  addMaskOptions(*command, batch.input);
  command
      ->add_option_function<std::string>(
          "--time", [options](const std::string& text) { options->time = stepRange(text); },
          "time steps of a recording: all, a number from 1, or two with a dash; several give a mesh and a "
          "picture each, and a film where ffmpeg is there")
      ->type_name("all|N|A-B");
  addChoices(*command, "--export", batch.meshFormats, extensionWords(FileKind::writtenMesh),
             "formats of the mesh, with commas");
  addChoices(*command, "--keep", options->keep, {"classified", "thinned", "points"},
             "results on the way to write too, with commas");
  addBakeOption(*command, batch.bake);
  addQualityOption(*command, batch.skinQuality);
  addSizeOption(*command, batch.pictureSize);
  addBackendOption(*command, batch.backend);
  console.addThreads(*command);
  console.addJson(*command);
  console.addNameInput(*command);
  options->parameters.addTo(*command);
  return {command, [options, &console, command] {
            options->batch.turnsFormat = command->count("--size") == 0;
            run(*options, console);
          }};
}

}  // namespace sonoskin
