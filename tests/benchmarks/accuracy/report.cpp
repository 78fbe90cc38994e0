#include "tests/benchmarks/accuracy/report.h"

#include <fmt/format.h>

#include <algorithm>

namespace sonoskin::accuracy {
namespace {

std::string nameOf(const Row& row) {
  return row.settings.empty() ? row.method : row.method + " " + row.settings;
}

std::string threeOf(const Found& f) {
  return fmt::format("{:.2f} {:.2f} {:.3f}", f.precision, f.recall, f.f());
}

// The values of `key` in order of appearance.
template <class Key>
std::vector<std::string> distinct(const std::vector<Row>& rows, const Key& key) {
  std::vector<std::string> found;
  for (const Row& row : rows)
    if (std::find(found.begin(), found.end(), key(row)) == found.end()) found.push_back(key(row));
  return found;
}

}  // namespace

std::string machineLine(const Row& r) {
  const Score& s = r.score;
  return fmt::format(
      "level={} snr={} cnr={:.2f} method={} settings={} iso={:.3f} points={} p15={:.4f} r15={:.4f} "
      "f15={:.4f} "
      "p3={:.4f} r3={:.4f} f3={:.4f} rawf15={:.4f} rawf3={:.4f} offset={:.3f} offsetmm={:.3f} rms={:.3f} "
      "cpu={:.2f}",
      r.level, r.snr, r.contrast, r.method, r.settings.empty() ? "-" : r.settings, r.isoValue, s.points,
      s.debiased15.precision, s.debiased15.recall, s.debiased15.f(), s.debiased3.precision,
      s.debiased3.recall, s.debiased3.f(), s.raw15.f(), s.raw3.f(), s.offsetVoxels, s.offsetMm, s.residual,
      r.seconds);
}

std::string levelTable(const std::vector<Row>& rows) {
  std::string text = fmt::format("### Level {}: phantom.snr {} dB, contrast-to-noise {:.1f}\n\n",
                                 rows.front().level, rows.front().snr, rows.front().contrast);
  text +=
      "| method | points | P R F at 1.5, debiased | at 3 | P R F at 1.5, raw | at 3 | offset voxels (mm) | "
      "residual RMS voxels | CPU s |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Row& r : rows) {
    const Score& s = r.score;
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {:+.2f} ({:+.2f}) | {:.2f} | {:.1f} |\n", nameOf(r),
                        s.points, threeOf(s.debiased15), threeOf(s.debiased3), threeOf(s.raw15),
                        threeOf(s.raw3), s.offsetVoxels, s.offsetMm, s.residual, r.seconds);
  }
  return text;
}

std::string summaryTable(const std::vector<Row>& rows) {
  const auto levels = distinct(rows, [](const Row& r) { return r.level; });
  std::string text = "| method |", rule = "\n|---|";
  for (const std::string& level : levels) text += " " + level + " |", rule += "---|";
  text += " what it does |" + rule + "---|\n";
  for (const std::string& method : distinct(rows, nameOf)) {
    text += "| " + method + " |";
    std::string help;
    for (const std::string& level : levels) {
      const auto row = std::find_if(rows.begin(), rows.end(),
                                    [&](const Row& r) { return r.level == level && nameOf(r) == method; });
      if (row == rows.end()) {
        text += " |";
        continue;
      }
      text += fmt::format(" {:.3f} ({:.2f}) |", row->score.debiased15.f(), row->score.debiased3.f());
      help = row->help;
    }
    text += " " + help + " |\n";
  }
  return text;
}

}  // namespace sonoskin::accuracy
