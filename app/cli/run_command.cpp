#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "app/batch/batch.h"
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
};

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
  batch.keepClassified = keeps("classified");
  batch.keepThinned = keeps("thinned");
  batch.keepPoints = keeps("points");
  const Report report =
      runBatch(batch, console.progress(), [&](const std::string& stage) { console.beginStage(stage); });
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
