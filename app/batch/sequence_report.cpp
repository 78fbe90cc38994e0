#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/batch/sequence.h"
#include "core/base/version.h"

namespace sonoskin {

std::string sequenceJson(const SequenceReport& report) {
  using Json = nlohmann::ordered_json;
  Json json{{"version", kVersion},
            {"input", report.input},
            {"time_steps", report.timeSteps},
            {"steps", Json::array()},
            {"without_surface", Json::array()}};
  if (report.stepSeconds > 0) json["step_seconds"] = report.stepSeconds;
  for (const ReportedStep& step : report.steps) {
    Json one{{"time", step.time},
             {"points", step.points},
             {"triangles", step.triangles},
             {"area_mm2", step.area},
             {"iso_value", step.isoValue}};
    if (step.face.fit) one["face"] = Json::parse(faceJson(step.face));
    json["steps"].push_back(one);
  }
  for (const NoSurface& none : report.missing)
    json["without_surface"].push_back({{"time", none.time}, {"why", none.why}});
  json["warnings"] = report.warnings;
  json["notes"] = report.notes;
  json["seconds"] = report.seconds;
  json["files"] = report.files;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string sequenceText(const SequenceReport& report, const std::filesystem::path& folder) {
  std::string text =
      fmt::format("{} of {} time steps, {:.1f} s\n", report.steps.size(), report.timeSteps, report.seconds);
  for (const ReportedStep& step : report.steps)
    text += fmt::format("step {}: {} triangles, {:.0f} mm2, {}\n", step.time, step.triangles, step.area,
                        step.face.text);
  for (const NoSurface& none : report.missing) text += fmt::format("step {}: no surface\n", none.time);
  return text + fmt::format("{} files in {}\n", report.files.size(), folder.string());
}

}  // namespace sonoskin
