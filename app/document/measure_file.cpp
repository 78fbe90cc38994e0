#include "app/document/measure_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/document/session_file.h"
#include "core/base/error.h"
#include "core/base/log.h"

namespace sonoskin {
namespace {

using Json = nlohmann::json;

constexpr double kFar = 1e6;  // mm from the origin: further away lies no scan

std::optional<glm::dvec3> markIn(const Json& json) {
  if (!json.is_array() || json.size() != 3) return {};
  glm::dvec3 mark(0);
  for (int i = 0; i < 3; ++i) {
    const Json& number = json[std::size_t(i)];
    if (!number.is_number() || !(std::abs(number.get<double>()) <= kFar)) return {};
    mark[i] = number.get<double>();
  }
  return mark;
}

std::optional<Measure> measureIn(const Json& json) {
  if (!json.is_object() || !json.contains("kind") || !json.contains("marks")) return {};
  Measure measure;
  const auto names = enumNames(MeasureKind{});
  const auto kind = std::ranges::find_if(names, [&](const char* name) { return json["kind"] == name; });
  const Json& marks = json["marks"];
  if (kind == names.end() || !marks.is_array() || marks.size() > kMostMarks) return {};
  measure.kind = MeasureKind(kind - names.begin());
  for (const Json& element : marks) {
    const auto mark = markIn(element);
    if (!mark) return {};
    measure.marks.push_back(*mark);
  }
  return isComplete(measure) ? std::optional(measure) : std::nullopt;
}

// A session; nothing of any other text, or of one that is damaged.
std::optional<SessionFile> sessionIn(const std::string& text) try {
  return readSessionFile(text);
} catch (const Error&) {
  return {};
}

double rounded(double value) { return std::round(value * 1000) / 1000 + 0.0; }

const char* unitOf(MeasureKind kind) {
  return kind == MeasureKind::distance ? "mm" : kind == MeasureKind::angle ? "degrees" : "mm2";
}

const char* nameOf(MeasureKind kind) { return enumNames(kind)[std::size_t(kind)]; }

}  // namespace

std::vector<Measure> measuresIn(const std::string& text) {
  std::vector<Measure> measures;
  const auto session = sessionIn(text);
  const Json views = session ? Json::parse(session->views, nullptr, false) : Json();
  if (!views.is_object() || !views.contains("measures")) return measures;
  const Json list = views["measures"].is_array() ? views["measures"] : Json::array({views["measures"]});
  for (const Json& element : list)
    if (const auto measure = measureIn(element)) measures.push_back(*measure);
  if (const std::size_t lost = list.size() - measures.size(); lost > 0)
    log(LogLevel::warning, fmt::format("{} measure{} of the session could not be read and {} left out.", lost,
                                       lost == 1 ? "" : "s", lost == 1 ? "is" : "are"));
  return measures;
}

std::string measuresJson(const std::vector<Measure>& measures) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Measure& measure : measures) {
    nlohmann::ordered_json json{
        {"kind", nameOf(measure.kind)}, {"value", rounded(valueOf(measure))}, {"unit", unitOf(measure.kind)}};
    for (const glm::dvec3& mark : measure.marks)
      json["marks_mm"].push_back({rounded(mark.x), rounded(mark.y), rounded(mark.z)});
    list.push_back(std::move(json));
  }
  return list.dump();
}

std::string measuresText(const std::vector<Measure>& measures) {
  std::string text;
  for (const Measure& measure : measures) {
    text += fmt::format("{} {} at", nameOf(measure.kind), measureText(measure));
    for (const glm::dvec3& mark : measure.marks)
      text += fmt::format("{} {:.1f}, {:.1f}, {:.1f}", &mark == &measure.marks.front() ? "" : ";", mark.x,
                          mark.y, mark.z);
    text += " mm\n";
  }
  return text;
}

}  // namespace sonoskin
