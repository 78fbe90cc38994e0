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
  batch.parameters = options.parameters.resolve(batch.input);
  const bool canBake = std::ranges::any_of(batch.meshFormats, [](const std::string& format) {
    return formatNamed(FileKind::texturedMesh, "mesh." + format).has_value();
  });
  if (batch.bake != Bake::none && !canBake)
    throw Error(fmt::format("--bake needs a format that holds pictures; let --export name {}.",
                            fmt::join(extensionWords(FileKind::texturedMesh), " or ")),
                Error::Kind::usage);
  requireSound(batch.meshFile.patient);
  if (batch.meshFile.patient.isGiven() && std::ranges::count(batch.meshFormats, "dcm") == 0)
    throw Error("A patient is named in mesh.dcm alone; let --export name dcm.", Error::Kind::usage);
  const auto keeps = [&](const char* name) { return std::ranges::count(options.keep, name) > 0; };
  batch.inputName = console.nameOf(batch.input.volume);
  const auto stage = [&](const std::string& name) { console.beginStage(name); };
  if (isSequence(options)) {
    refuseForSequences(options);
    const SequenceReport report = runSequence(batch, *options.time, console.progress(), stage);
    return console.print(sequenceJson(report), sequenceText(report, batch.folder));
  }
  batch.keepScan = keeps("scan");
  batch.keepClassified = keeps("classified");
  batch.keepThinned = keeps("thinned");
  batch.keepPoints = keeps("points");
  const Report report = runBatch(batch, console.progress(), stage);
  console.print(reportJson(report), reportText(report, batch.folder));
}

// Those that keep how a volume lies.
std::vector<std::string> keptFormats() {
  std::vector<std::string> formats = extensionWords(FileKind::writtenVolume);
  std::erase_if(formats, [](const std::string& word) {
    return formatNamed(FileKind::writtenVolume, "scan." + word) == FileFormat::vtk;
  });
  return formats;
}

// What the formats that prescribe frame and unit do not heed.
void addPlacementOptions(CLI::App& command, MeshPlacement& placement) {
  addEnum(
      command, "--mesh-frame", placement.frame, 0,
      "for ply, stl, obj and vtp: lps as DICOM has it, ras with x and y the other way round [default lps]");
  addEnum(command, "--mesh-unit", placement.unit, 0, "for ply, stl, obj and vtp [default mm]");
}

// A patient is named where the person asked for it, and nowhere else.
void addPatientOptions(CLI::App& command, DicomPatient& patient) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    command.add_option(name, value, help)->type_name("TEXT");
  };
  add("--patient-name", patient.name,
      "whose mesh.dcm it is, as in Doe^Jane; without these four it is nobody's");
  add("--patient-id", patient.id, "the patient's ID in mesh.dcm");
  add("--patient-birth-date", patient.birthDate, "eight digits, year first, in mesh.dcm");
  add("--patient-sex", patient.sex, "M, F or O, in mesh.dcm");
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
  addChoices(*command, "--keep", options->keep, {"scan", "classified", "thinned", "points"},
             "results on the way to write too, with commas; scan: the volume as it was read, and its mask");
  addChoice(*command, "--keep-as", batch.volumeFormat, keptFormats(), "format of the volumes that are kept");
  addPlacementOptions(*command, batch.meshFile.placement);
  addPatientOptions(*command, batch.meshFile.patient);
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
