#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/batch/mesh_text.h"
#include "app/cli/commands.h"
#include "app/cli/parameter_options.h"
#include "app/document/input.h"
#include "app/document/parameter_text.h"
#include "core/base/error.h"
#include "core/io/file_formats.h"
#include "core/io/mesh_reader.h"
#include "core/io/volume_reader.h"
#include "core/mesh/facts/mesh_doubts.h"

namespace sonoskin {
namespace {

struct InfoOptions {
  std::string file;
  ParameterOptions reading;  // how it is read: scan.volume, scan.time, scan.voxel and the group raw
  bool formats = false;
};

// Without -0, which means nothing to people.
nlohmann::ordered_json vectorJson(const glm::dvec3& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

std::string infoJson(const std::string& name, const VolumeInfo& info) {
  const Geometry& g = info.geometry;
  nlohmann::ordered_json json;
  if (!name.empty()) json["file"] = name;
  json["fingerprint"] = info.key.hex();
  json["format"] = info.format;
  json["dims"] = {g.dims.x, g.dims.y, g.dims.z};
  json["spacing_mm"] = vectorJson(g.spacing);
  json["spacing_known"] = info.spacingKnown;
  json["origin_mm"] = vectorJson(g.origin);
  json["direction"] = {vectorJson(g.direction[0]), vectorJson(g.direction[1]), vectorJson(g.direction[2])};
  json["mirrored"] = g.mirrors();
  if (info.grid) {
    const glm::ivec3 samples = gridDims(*info.grid);
    json["converted_from"] = {{"grid", gridName(*info.grid)}, {"samples", {samples.x, samples.y, samples.z}}};
  }
  json["number_type"] = info.numberType;
  json["components"] = info.components;
  json["time_steps"] = info.timeSteps;
  if (info.stepSeconds > 0) json["step_seconds"] = info.stepSeconds;
  json["value_range"] = {info.valueMin, info.valueMax};
  json["file_bytes"] = info.bytes;
  if (info.beam) {
    json["beam"]["axis"] = vectorJson(info.beam->axis);
    json["beam"]["up"] = vectorJson(info.beam->up);
    if (info.beam->apex) json["beam"]["apex_mm"] = vectorJson(*info.beam->apex);
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// "3 steps, 0.033 s apart"
std::string timeText(const VolumeInfo& info) {
  const std::string steps = fmt::format("{} steps", info.timeSteps);
  return info.stepSeconds > 0 ? fmt::format("{}, {:.4g} s apart", steps, info.stepSeconds) : steps;
}

std::string infoText(const std::string& name, const VolumeInfo& info) {
  const Geometry& g = info.geometry;
  const glm::dvec3 size = g.spacing * glm::dvec3(g.dims);
  std::string text = fmt::format("{}: {}, {:.1f} MB\n", name, info.format, double(info.bytes) * 1e-6);
  text += fmt::format("  voxels     {} x {} x {}\n", g.dims.x, g.dims.y, g.dims.z);
  text += fmt::format("  spacing    {:.4g} x {:.4g} x {:.4g} mm{}\n", g.spacing.x, g.spacing.y, g.spacing.z,
                      info.spacingKnown ? "" : "  (assumed: the file gives none)");
  text += fmt::format("  size       {:.1f} x {:.1f} x {:.1f} mm\n", size.x, size.y, size.z);
  text += fmt::format("  origin     {:.4g}, {:.4g}, {:.4g} mm (LPS)\n", g.origin.x, g.origin.y, g.origin.z);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 d = g.direction[axis] + 0.0;
    text += fmt::format("  axis {}     {:.4g}, {:.4g}, {:.4g}\n", "ijk"[axis], d.x, d.y, d.z);
  }
  if (g.mirrors()) text += "  mirrored   the axes are left-handed\n";
  if (info.grid) {
    const glm::ivec3 samples = gridDims(*info.grid);
    text += fmt::format("  converted  from a {} of {} x {} x {} samples\n", gridName(*info.grid), samples.x,
                        samples.y, samples.z);
  }
  text += fmt::format("  numbers    {} x {}, {:g} .. {:g}\n", info.components, info.numberType, info.valueMin,
                      info.valueMax);
  if (info.timeSteps > 1) text += fmt::format("  time       {}\n", timeText(info));
  text += fmt::format("  probe      {}\n", !info.beam        ? "the file does not say; see --scan.probeSide"
                                           : info.beam->apex ? "beams from a point"
                                                             : "parallel beams");
  return text;
}

void printMesh(const std::string& file, Console& console) {
  console.beginStage("reading");
  const Mesh mesh = readMesh(file, console.progress().part(0, 0.3));
  console.beginStage("checking");
  console.warn(meshDoubts(mesh));
  const MeshFacts facts = measureMesh(mesh, console.progress().part(0.3, 1));
  nlohmann::ordered_json json;
  if (const std::string name = console.nameOf(file); !name.empty()) json["file"] = name;
  json.update(nlohmann::ordered_json::parse(factsJson(facts)));
  json["warnings"] = console.warnings();
  console.print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
                inputName(file) + ":\n" + factsText(facts));
}

// Of several volumes, which there are.
void printVolumes(const std::string& file, const std::vector<VolumeEntry>& volumes, Console& console) {
  nlohmann::ordered_json json;
  if (const std::string name = console.nameOf(file); !name.empty()) json["file"] = name;
  std::string text =
      fmt::format("{} holds {} volumes; --volume N tells more of one:\n", inputName(file), volumes.size());
  for (std::size_t n = 0; n < volumes.size(); ++n) {
    const VolumeEntry& v = volumes[n];
    json["volumes"].push_back({{"volume", n + 1},
                               {"dims", {v.dims.x, v.dims.y, v.dims.z}},
                               {"modality", v.modality},
                               {"time_steps", v.timeSteps}});
    text += fmt::format("  {}  {}\n", n + 1, entryText(v));
  }
  console.print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace), text);
}

void printVolume(const std::string& file, const Parameters& parameters, Console& console) {
  const ReadOptions options = readOptions(parameters.scan, parameters.raw);
  if (options.volume == 0)
    if (const auto volumes = listVolumes(file, options); volumes.size() > 1)
      return printVolumes(file, volumes, console);
  const VolumeInfo info = readVolumeInfo(file, options, console.progress());
  console.print(infoJson(console.nameOf(file), info), infoText(inputName(file), info));
}

void info(const InfoOptions& options, Console& console) {
  if (options.file.empty() != options.formats)
    throw Error("Either a FILE or --formats is needed; see sonoskin info --help.", Error::Kind::usage);
  if (options.formats)
    console.print(nlohmann::ordered_json{{"formats", formatTable()}}.dump(2), formatTable());
  else if (isMeshFile(options.file))
    printMesh(options.file, console);
  else
    printVolume(options.file, options.reading.resolve(), console);
}

}  // namespace

Command addInfoCommand(CLI::App& program, Console& console) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand(
      "info", "what is in a volume file, without patient data; of a mesh whether it can be printed");
  command->add_option("FILE", options->file, "volume or mesh file, or a folder of DICOM files")
      ->type_name("");
  command->add_flag("--formats", options->formats,
                    "a table of the formats instead: their endings and what they keep");
  options->reading.addOne(*command, "volume", "scan.volume");
  options->reading.addOne(*command, "time", "scan.time");
  options->reading.addOne(*command, "", "scan.voxel");
  options->reading.addOne(*command, "", "scan.regionOnly");
  for (const ParameterInfo& parameter : describeParameters({}))
    if (parameter.name.starts_with("raw.")) options->reading.addOne(*command, "", parameter.name);
  console.addThreads(*command);
  console.addJson(*command);
  console.addNameInput(*command);
  return {command, [options, &console] { info(*options, console); }};
}

}  // namespace sonoskin
