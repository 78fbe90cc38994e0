#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/document/input.h"
#include "core/io/mesh_reader.h"
#include "core/mesh/facts/mesh_doubts.h"
#include "core/mesh/search/mesh_distance.h"

namespace sonoskin {
namespace {

struct CompareOptions {
  std::string a, b;
};

// Row: one direction of the comparison, over everything or over what the probe can have seen.
struct Row {
  const char* key;
  const char* title;
  const DistanceStatistics& statistics;
};

std::vector<Row> rowsOf(const MeshDistances& d) {
  return {{"visible_a_to_b", "A to B, where the probe sees B", d.visibleAToB},
          {"visible_b_to_a", "B to A, where the probe sees B", d.visibleBToA},
          {"a_to_b", "A to B, everywhere", d.aToB},
          {"b_to_a", "B to A, everywhere", d.bToA}};
}

std::string comparisonJson(const CompareOptions& options, const Console& console,
                           const MeshDistances& distances) {
  nlohmann::ordered_json json;
  if (const std::string a = console.nameOf(options.a); !a.empty()) json["a"] = a;
  if (const std::string b = console.nameOf(options.b); !b.empty()) json["b"] = b;
  for (const auto& [key, title, s] : rowsOf(distances)) {
    json[key] = {{"vertices", s.vertices},
                 {"area_mm2", s.area},
                 {"mean_mm", s.mean},
                 {"rms_mm", s.rms},
                 {"p95_mm", s.p95},
                 {"max_mm", s.max},
                 {"signed_mean_mm", s.signedMean},
                 {"signed_median_mm", s.signedMedian},
                 {"normal_angle_deg", s.normalAngle}};
  }
  json["warnings"] = console.warnings();
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string comparisonText(const MeshDistances& distances) {
  std::string text = fmt::format("{:<32}{:>9}{:>8}{:>8}{:>8}{:>8}{:>9}{:>9}\n", "mm", "cm2", "mean", "RMS",
                                 "p95", "max", "offset", "normals");
  for (const auto& [key, title, s] : rowsOf(distances)) {
    text += fmt::format("{:<32}{:>9.1f}{:>8.3f}{:>8.3f}{:>8.3f}{:>8.3f}{:>+9.3f}{:>8.1f}°\n", title,
                        s.area / 100, s.mean, s.rms, s.p95, s.max, s.signedMedian, s.normalAngle);
  }
  return text + "offset: median of the signed distance, + outside; normals: mean angle between them\n";
}

void compare(const CompareOptions& options, Console& console) {
  console.beginStage("reading");
  const Mesh a = readMesh(options.a, console.progress().part(0, 0.1));
  const Mesh b = readMesh(options.b, console.progress().part(0.1, 0.2));
  console.warn(pairDoubts(a, b));
  console.beginStage("distances");
  const MeshDistances distances = measureDistances(a, b, console.progress().part(0.2, 1));
  console.print(comparisonJson(options, console, distances), comparisonText(distances));
}

}  // namespace

Command addCompareCommand(CLI::App& program, Console& console) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = program.add_subcommand("compare", "distances between two meshes, both ways");
  command->add_option("A", options->a, "the mesh to judge")->required()->type_name("");
  command
      ->add_option("B", options->b, "the reference; its property `visibility` says what the probe sees of it")
      ->required()
      ->type_name("");
  console.addThreads(*command);
  console.addJson(*command);
  console.addNameInput(*command);
  return {command, [options, &console] { compare(*options, console); }};
}

}  // namespace sonoskin
