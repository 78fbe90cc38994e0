#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/output_file.h"
#include "app/cli/parameter_options.h"
#include "app/document/input.h"
#include "core/base/version.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"

namespace sonoskin {
namespace {

struct PhantomCommandOptions {
  ParameterOptions parameters;
  std::string out, truth;
};

void phantom(const PhantomCommandOptions& options, Console& console) {
  checkOutputFile(options.out, FileKind::writtenVolume);
  if (!options.truth.empty()) checkOutputFile(options.truth, FileKind::writtenMesh);
  const PhantomOptions phantom = options.parameters.resolve().phantom;
  const double scanShare = options.truth.empty() ? 0.9 : 0.6;

  console.beginStage("simulation");
  const Scan scan = makePhantomScan(phantom, console.progress().part(0, scanShare));
  Mesh truth;
  if (!options.truth.empty()) {
    console.beginStage("true skin");
    truth = makePhantomTruth(phantom, console.progress().part(scanShare, 0.9));
  }
  console.beginStage("files");
  if (!options.truth.empty()) writeMesh(options.truth, truth, console.progress().part(0.9, 0.93));
  writeScan(options.out, scan, console.progress().part(0.93, 1));

  const Geometry& g = scan.volume->geometry;
  nlohmann::ordered_json json;
  json["version"] = kVersion;
  json["file"] = inputName(options.out);
  if (!options.truth.empty()) json["truth"] = inputName(options.truth);
  json["dims"] = {g.dims.x, g.dims.y, g.dims.z};
  json["spacing_mm"] = {g.spacing.x, g.spacing.y, g.spacing.z};
  json["scene"] = enumNames(phantom.scene)[std::size_t(phantom.scene)];
  json["shape"] = phantom.shape;
  json["snr_db"] = phantom.snr;
  json["seed"] = phantom.seed;
  json["key"] = scan.key.hex();
  if (!options.truth.empty()) json["truth_triangles"] = truth.triangles.size();
  console.print(
      json.dump(2),
      fmt::format("{}: {} x {} x {} voxels of {:.3g} x {:.3g} x {:.3g} mm, {}, shape {}, {} dB, seed {}",
                  options.out, g.dims.x, g.dims.y, g.dims.z, g.spacing.x, g.spacing.y, g.spacing.z,
                  enumNames(phantom.scene)[std::size_t(phantom.scene)], phantom.shape, phantom.snr,
                  phantom.seed));
}

}  // namespace

Command addPhantomCommand(CLI::App& program, Console& console) {
  auto options = std::make_shared<PhantomCommandOptions>();
  CLI::App* command = program.add_subcommand("phantom", "simulate the scan of a sleeping newborn");
  command
      ->add_option("--out", options->out,
                   fmt::format("volume to write: {}", extensionList(FileKind::writtenVolume)))
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--truth", options->truth,
                   fmt::format("mesh of the true skin to write: {}; of these .ply keeps what the probe sees",
                               extensionList(FileKind::writtenMesh)))
      ->type_name("FILE");
  options->parameters.addOne(*command, "dims", "phantom.dims");
  options->parameters.addOne(*command, "scene", "phantom.scene");
  options->parameters.addOne(*command, "shape", "phantom.shape");
  options->parameters.addOne(*command, "snr", "phantom.snr");
  options->parameters.addOne(*command, "seed", "phantom.seed");
  options->parameters.addRecipe(*command);
  console.addThreads(*command);
  console.addJson(*command);
  return {command, [options, &console] { phantom(*options, console); }};
}

}  // namespace sonoskin
