#include "app/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "app/mesh_text.h"
#include "core/base/version.h"

namespace sonoskin {

namespace {

std::string printText(const MeshFacts& print) {
  return fmt::format(
      "the solid to print has {} triangles and {:.1f} cm3: {}\n", print.triangles, print.volume / 1000,
      print.printable() ? "closed, manifold, nothing crosses"
                        : fmt::format("not clean, {} pairs of triangles cross", print.selfIntersections));
}

}  // namespace

std::string reportJson(const Report& report) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::array();
  for (const StageReport& stage : report.stages) {
    stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"bytes", stage.bytes}});
  }
  nlohmann::ordered_json json;
  json["version"] = kVersion;
  json["input"] = report.input;
  json["dims"] = report.dims;
  json["spacing_mm"] = report.spacing;
  json["spacing_known"] = report.spacingKnown;
  json["iso_value"] = report.isoValue;
  json["erased_voxels"] = report.erasedVoxels;
  json["stages"] = stages;
  json["points"] = report.points;
  json["edge"] = {{"dark", report.edge.dark},         {"bright", report.edge.bright},
                  {"steepest", report.edge.steepest}, {"width_mm", report.edge.width},
                  {"shift_mm", report.edge.shift},    {"depth_mm", report.edge.depth}};
  json["centres"] = report.centres;
  json["global_error"] = report.globalError;
  if (report.globalErrorWithWeights) json["global_error_with_weights"] = *report.globalErrorWithWeights;
  json["pieces"] = report.pieces;
  if (report.face.fit) json["face"] = nlohmann::ordered_json::parse(faceJson(report.face));
  json["triangles"] = report.mesh.triangles;
  json["area_mm2"] = report.mesh.area;
  json["mesh"] = nlohmann::ordered_json::parse(factsJson(report.mesh));
  if (report.print) json["print"] = nlohmann::ordered_json::parse(factsJson(*report.print));
  json["seconds"] = report.seconds;
  json["peak_memory_bytes"] = report.peakMemory;
  json["threads"] = report.threads;
  json["gl"] = report.gl;
  json["files"] = report.files;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string reportText(const Report& report, const std::filesystem::path& folder) {
  std::string text = fmt::format("{}: {} voxels of {:.3g} mm{}\n", report.input,
                                 fmt::join(report.dims, " x "), fmt::join(report.spacing, " x "),
                                 report.spacingKnown ? "" : " (assumed: the file gives no spacing)");
  text += fmt::format("{} points, {} centres, {} pieces; the mesh has {} triangles and {:.1f} cm2\n",
                      report.points, report.centres, report.pieces, report.mesh.triangles,
                      report.mesh.area / 100);
  if (report.print) text += printText(*report.print);
  if (report.edge.width > 0)
    text += fmt::format(
        "the skin's edge rises from grey {:.2f} to {:.2f} within {:.1f} mm (20 to 80 %); iso-value {:.2f}\n",
        report.edge.dark, report.edge.bright, report.edge.width, report.isoValue);
  for (const std::string& sentence : {report.face.text, report.face.warning})
    if (!sentence.empty()) text += sentence + "\n";
  for (const StageReport& stage : report.stages) {
    text += fmt::format("  {:<24} {:7.2f} s  {:7.1f} MB\n", stage.name, stage.seconds,
                        double(stage.bytes) * 1e-6);
  }
  text += fmt::format("{:.1f} s on {} threads, {:.0f} MB of memory at most\n", report.seconds, report.threads,
                      double(report.peakMemory) * 1e-6);
  text += fmt::format("in {}: {}\n", folder.string(), fmt::join(report.files, ", "));
  return text;
}

std::size_t peakMemoryBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t(usage.ru_maxrss) * 1024;
}

}  // namespace sonoskin
