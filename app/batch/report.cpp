#include "app/batch/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/batch/mesh_text.h"
#include "app/document/measure_file.h"
#include "core/base/version.h"

namespace sonoskin {

namespace {

std::string printText(const MeshFacts& print) {
  return fmt::format(
      "the solid to print has {} triangles and {:.1f} cm3: {}\n", print.triangles, print.volume / 1000,
      print.printable() ? "closed, manifold, nothing crosses"
                        : fmt::format("not clean, {} pairs of triangles cross", print.selfIntersections));
}

std::array<double, 3> rounded(const glm::vec3& place) {
  std::array<double, 3> result{};
  for (int i = 0; i < 3; ++i) result[std::size_t(i)] = std::round(double(place[i]) * 100) / 100;
  return result;
}

nlohmann::ordered_json partsJson(const std::vector<ReportedPart>& parts) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ReportedPart& part : parts)
    list.push_back({{"area_mm2", part.area},
                    {"centre_mm", part.centre},
                    {"place_mm", part.place},
                    {"kept", part.kept},
                    {"why", part.why}});
  return list;
}

nlohmann::ordered_json isoJson(const Report& report) {
  const IsoRange& range = report.isoRange;
  return {{"automatic", range.automatic}, {"share", report.isoShare}, {"fluid", range.fluid},
          {"edge", range.edge},           {"least", range.least},     {"most", range.most}};
}

std::string isoText(const Report& report) {
  const IsoRange& range = report.isoRange;
  if (!range.automatic) return fmt::format("iso-value {:.2f}, as given\n", report.isoValue);
  const std::string places = range.least < range.most ? fmt::format(", {:.2f} to {:.2f} from place to place",
                                                                    range.least, range.most)
                                                      : "";
  return fmt::format(
      "iso-value {:.2f}{}: {:.0f} % of the way from the fluid's grey {:.2f} to the edges' {:.2f}\n",
      report.isoValue, places, 100 * report.isoShare, range.fluid, range.edge);
}

std::string partsText(const std::vector<ReportedPart>& parts) {
  const auto kept = std::count_if(parts.begin(), parts.end(), [](const ReportedPart& p) { return p.kept; });
  return fmt::format("{} of {} parts of the surface are kept\n", kept, parts.size());
}

}  // namespace

std::vector<ReportedPart> reportParts(const Results& results) {
  std::vector<ReportedPart> list;
  if (!results.parts || !results.verdicts) return list;
  for (std::size_t p = 0; p < results.verdicts->size(); ++p) {
    const Part& part = results.parts->parts.parts[p];
    const PartVerdict& verdict = (*results.verdicts)[p];
    list.push_back({std::round(part.area * 10) / 10, rounded(part.centre), rounded(part.place), verdict.kept,
                    enumNames(verdict.reason)[std::size_t(verdict.reason)]});
  }
  return list;
}

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
  json["iso"] = isoJson(report);
  json["warnings"] = report.warnings;
  json["notes"] = report.notes;
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
  if (!report.measures.empty())
    json["measures"] = nlohmann::ordered_json::parse(measuresJson(report.measures));
  json["parts"] = partsJson(report.parts);
  json["triangles"] = report.mesh.triangles;
  json["area_mm2"] = report.mesh.area;
  json["measured"] = {{"area_mm2", report.measured.measured},
                      {"filled_mm2", report.measured.filled},
                      {"holes_closed", report.measured.holes}};
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
  if (!report.parts.empty()) text += partsText(report.parts);
  if (report.print) text += printText(*report.print);
  text += isoText(report);
  if (report.edge.width > 0)
    text += fmt::format("the skin's edge rises from grey {:.2f} to {:.2f} within {:.1f} mm (20 to 80 %)\n",
                        report.edge.dark, report.edge.bright, report.edge.width);
  if (!report.face.text.empty()) text += report.face.text + "\n";
  text += measuresText(report.measures);
  for (const StageReport& stage : report.stages) {
    text += fmt::format("  {:<24} {:7.2f} s  {:7.1f} MB\n", stage.name, stage.seconds,
                        double(stage.bytes) * 1e-6);
  }
  text += fmt::format("{:.1f} s on {} threads, {:.0f} MB of memory at most\n", report.seconds, report.threads,
                      double(report.peakMemory) * 1e-6);
  if (!report.files.empty())
    text += fmt::format("in {}: {}\n", folder.string(), fmt::join(report.files, ", "));
  return text;
}

std::size_t peakMemoryBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t(usage.ru_maxrss) * 1024;
}

}  // namespace sonoskin
