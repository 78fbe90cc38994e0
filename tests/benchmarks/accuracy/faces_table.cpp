#include "tests/benchmarks/accuracy/faces_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace sonoskin::accuracy {
namespace {

// How the runs of a scene become a cell: median and worst, or the mean alone. farthest: from 0.
enum class Worst { largest, smallest, farthest, mean };

// Metric: one number of a score, as CSV and tables have it.
struct Metric {
  const char* key;
  const char* heading;
  double FaceScore::*value;
  int decimals = 2;
  double unit = 1;  // what 1 is in the table: 100 for per cent
  Worst worst = Worst::largest;
};

constexpr Metric kSurface[] = {
    {"rms_mm", "RMS mm", &FaceScore::rms},
    {"p95_mm", "p95 mm", &FaceScore::p95},
    {"max_mm", "max mm", &FaceScore::max, 1},
    {"offset_mm", "offset mm", &FaceScore::offset, 2, 1, Worst::farthest},
    {"border_mm", "border RMS mm", &FaceScore::border},
    {"interior_mm", "interior RMS mm", &FaceScore::interior},
    {"covered", "covered %", &FaceScore::covered, 0, 100, Worst::smallest},
    {"foreign", "foreign %", &FaceScore::foreign, 1, 100},
    {"tissue", "of it tissue %", &FaceScore::tissue, 1, 100},
    {"spurs", "spurs", &FaceScore::spurs, 0},
    {"spur_area_mm2", "spurs mm²", &FaceScore::spurArea, 0},
    {"spurless", "runs without %", &FaceScore::spurless, 0, 100, Worst::mean},
    {"detail_deg", "detail °", &FaceScore::detail, 1},
    {"landmarks_mm", "landmarks mm", &FaceScore::landmarks, 1},
    {"pose_deg", "pose °", &FaceScore::pose, 1},
    {"cpu_s", "CPU s", &FaceScore::cpuSeconds, 1},
};
constexpr Metric kMore[] = {
    {"covered_face", "face %", &FaceScore::coveredFace, 0, 100, Worst::smallest},
    {"covered_head", "head %", &FaceScore::coveredHead, 0, 100, Worst::smallest},
    {"covered_hand", "hand %", &FaceScore::coveredHand, 0, 100, Worst::smallest},
    {"covered_body", "body %", &FaceScore::coveredBody, 0, 100, Worst::smallest},
    {"eyes_deg", "eyes °", &FaceScore::eyes, 1},
    {"nose_deg", "nose °", &FaceScore::nose, 1},
    {"mouth_deg", "mouth °", &FaceScore::mouth, 1},
    {"landmarks_max_mm", "worst landmark mm", &FaceScore::landmarksMax, 1},
    {"confidence", "confidence", &FaceScore::confidence, 2, 1, Worst::smallest},
    {"misled", "sure of a wrong face %", &FaceScore::misled, 0, 100, Worst::mean},
    {"rms_all_mm", "RMS with foreign mm", &FaceScore::rmsAll},
    {"max_all_mm", "max", &FaceScore::maxAll, 1},
    {"border_all_mm", "border", &FaceScore::borderAll},
    {"area_mm2", "area mm²", &FaceScore::area, 0, 1, Worst::smallest},
    {"triangles", "triangles", &FaceScore::triangles, 0},
    {"wall_s", "wall s", &FaceScore::wallSeconds, 1},
};

// In the CSV alone.
constexpr Metric kPlaces[] = {
    {"spur_x_mm", "", &FaceScore::spurX},
    {"spur_y_mm", "", &FaceScore::spurY},
    {"spur_z_mm", "", &FaceScore::spurZ},
};

using Metrics = std::span<const Metric>;
using Rows = std::vector<const FaceRow*>;

std::vector<double> valuesOf(const Rows& rows, const Metric& metric) {
  std::vector<double> values;
  for (const FaceRow* row : rows)
    if (const double value = row->score.*metric.value; !std::isnan(value)) values.push_back(value);
  return values;
}

double worstOf(const std::vector<double>& sorted, Worst worst) {
  const double low = sorted.front(), high = sorted.back();
  if (worst == Worst::smallest) return low;
  return worst == Worst::farthest && -low > high ? low : high;
}

std::string cell(const Rows& rows, const Metric& metric) {
  std::vector<double> values = valuesOf(rows, metric);
  if (values.empty()) return " - |";
  std::sort(values.begin(), values.end());
  if (metric.worst == Worst::mean) {
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
    return fmt::format(" {:.{}f} |", metric.unit * mean, metric.decimals);
  }
  const double median = (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
  return fmt::format(" {:.{}f} ({:.{}f}) |", metric.unit * median, metric.decimals,
                     metric.unit * worstOf(values, metric.worst), metric.decimals);
}

std::string nameOf(const FaceRow& row) {
  return row.settings.empty() ? row.scene : row.scene + ", " + row.settings;
}

std::string line(const std::string& name, const Rows& rows, Metrics metrics) {
  std::string text = fmt::format("| {} | {} |", name, rows.size());
  for (const Metric& metric : metrics) text += cell(rows, metric);
  return text + "\n";
}

// The rows by key(row), in order of appearance.
template <class Key>
std::vector<std::pair<std::string, Rows>> grouped(const std::vector<FaceRow>& rows, const Key& key) {
  std::vector<std::pair<std::string, Rows>> groups;
  for (const FaceRow& row : rows) {
    const std::string name = key(row);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == name; });
    if (group == groups.end()) group = groups.insert(groups.end(), {name, {}});
    group->second.push_back(&row);
  }
  return groups;
}

std::string table(const std::vector<FaceRow>& rows, Metrics metrics) {
  std::string text = "| scene | runs |", rule = "\n|---|---|";
  for (const Metric& metric : metrics) text += fmt::format(" {} |", metric.heading), rule += "---|";
  text += rule + "\n";
  const auto scenes = grouped(rows, nameOf);
  for (const auto& [name, group] : scenes) text += line(name, group, metrics);
  const auto all = grouped(rows, [](const FaceRow& row) { return row.settings; });
  if (scenes.size() > all.size())
    for (const auto& [settings, group] : all)
      text += line(settings.empty() ? "all" : "all, " + settings, group, metrics);
  return text;
}

}  // namespace

std::string faceTables(const std::vector<FaceRow>& rows) {
  return table(rows, kSurface) + "\n" + table(rows, kMore);
}

std::string faceCsv(const std::vector<FaceRow>& rows) {
  std::vector<Metric> metrics;
  for (const Metrics some : {Metrics(kSurface), Metrics(kMore), Metrics(kPlaces)})
    metrics.insert(metrics.end(), some.begin(), some.end());
  std::string text = "scene,shape,seed,settings";
  for (const Metric& metric : metrics) text += fmt::format(",{}", metric.key);
  text += "\n";
  for (const FaceRow& row : rows) {
    text += fmt::format("{},{},{},{}", row.scene, row.shape, row.seed, row.settings);
    for (const Metric& metric : metrics) {
      const double value = row.score.*metric.value;
      text += std::isnan(value) ? "," : fmt::format(",{:.6g}", value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace sonoskin::accuracy
