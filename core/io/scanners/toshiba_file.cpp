#include "core/io/scanners/toshiba_file.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/scanners/raw_numbers.h"
#include "core/io/text_keys.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr const char* kText = "PatientInfo.txt";
constexpr std::string_view kStart = "rawdata_vol", kEnding = ".bin";

// The N of RawData_VolN.bin.
std::optional<int> stepOf(const fs::path& file) {
  const std::string name = lowerCase(file.filename().string());
  if (!name.starts_with(kStart) || !name.ends_with(kEnding) || name.size() < kStart.size() + kEnding.size())
    return {};
  return parseNumber<int>(
      std::string_view(name).substr(kStart.size(), name.size() - kStart.size() - kEnding.size()));
}

bool isText(const fs::path& path) { return lowerCase(path.filename().string()) == lowerCase(kText); }

fs::path folderOf(const fs::path& path) { return fs::is_directory(path) ? path : path.parent_path(); }

// Recording: the files of one volume each, in the order of time.
std::vector<fs::path> recordingIn(const fs::path& path) {
  if (stepOf(path)) return {path};
  std::vector<std::pair<int, fs::path>> found;
  const fs::path folder = folderOf(path);
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, none))
    if (const auto step = stepOf(entry.path())) found.emplace_back(*step, entry.path());
  std::sort(found.begin(), found.end());
  std::vector<fs::path> files;
  for (auto& [step, file] : found) files.push_back(std::move(file));
  require(!files.empty(), "Beside {} there is no RawData_Vol1.bin or the like; copy the whole export.",
          path.string());
  return files;
}

int countOf(const KeyText& text, std::string_view key) {
  const double count = text.numberOf(key);
  require(count >= 2 && count <= 65535 && count == std::floor(count),
          "{} gives {} as {}; it must be a whole number of 2 or more.", text.path().string(), count, key);
  return int(count);
}

std::vector<double> evenly(int count, double half) {
  std::vector<double> values;
  for (int n = 0; n < count; ++n) values.push_back(half * (2.0 * n / (count - 1) - 1));
  return values;
}

// The middle of the probe's face, of the fan's apex where there is one, is the origin: from there the beams begin at
// AxialRoiStartMm, and the axis of the sweep lies MechRadiusMm behind their first samples.
SweptGrid gridOf(const KeyText& text) {
  SweptGrid grid;
  grid.samples = countOf(text, "Range");
  grid.sampleDistance = text.numberOf("RoiAxialSpanMm") / (grid.samples - 1);
  grid.firstRadius = text.numberOf("AxialRoiStartMm");
  grid.axisDepth = grid.firstRadius - text.numberOf("MechRadiusMm");
  const std::string probe = lowerCase(text.valueOf("Probe Type").value_or(""));
  grid.parallel = probe.starts_with("linear") || (probe.empty() && grid.axisDepth < 0);
  const double azimuth = text.numberOf("ApexAngleAzimuthHalf"),
               elevation = text.numberOf("ApexAngleElevationHalf");
  grid.fan = evenly(countOf(text, "Azimuth"), grid.parallel ? azimuth : glm::radians(azimuth));
  grid.sweep = evenly(countOf(text, "Elevation"), 0.5 * glm::radians(elevation));
  return grid;
}

void noteAssumptions(const SweptGrid& grid) {
  log(LogLevel::warning, grid.parallel ? "It is not certain what the export's angles mean: "
                                         "ApexAngleAzimuthHalf is taken for half the width of "
                                         "the parallel beams in mm, ApexAngleElevationHalf for the whole "
                                         "angle of the sweep in degrees, and "
                                         "the steering of the beams is left out."
                                       : "It is not certain what the export's angles mean: "
                                         "ApexAngleAzimuthHalf is taken for half the angle of "
                                         "the fan, ApexAngleElevationHalf for the whole angle of the sweep, "
                                         "and the steering of the beams is "
                                         "left out.");
}

}  // namespace

bool isToshiba(const fs::path& path) {
  std::error_code none;
  if (isText(path)) return fs::is_regular_file(path, none);
  if (!stepOf(path) && !fs::is_directory(path, none)) return false;
  const fs::path folder = folderOf(path);
  if (!fs::is_regular_file(folder / kText, none)) return false;
  if (stepOf(path)) return true;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (stepOf(entry.path())) return true;
  return false;
}

LoadedVolume readToshiba(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.update(0);
  const KeyText text(isText(path) ? path : folderOf(path) / kText, '=');
  const std::vector<fs::path> files = recordingIn(path);
  LoadedVolume loaded;
  StoredVolume& stored = loaded.stored;
  const SweptGrid grid = gridOf(text);
  const auto fault = gridFault(grid);
  require(!fault, "The beams that {} tells cannot be: {}.", text.path().string(), fault.value_or(""));
  noteAssumptions(grid);
  stored.format = "Toshiba raw data";
  stored.modality = "US";
  stored.grid = grid;
  stored.geometry.dims = gridDims(*stored.grid);
  stored.geometry.spacing = glm::dvec3(grid.sampleDistance);
  stored.timeSteps = int(std::min<std::size_t>(files.size(), 65535));
  checkTime(options.time, stored.timeSteps, path);
  RawNumbers numbers;
  numbers.file = files[std::size_t(options.time - 1)];
  numbers.frame = countNumbers(stored.geometry.dims, 1, path);
  loaded.numbers = readNumbers(numbers, path);
  for (const fs::path& file : files) loaded.bytes += fileSize(file);
  progress.update(1);
  return loaded;
}

}  // namespace sonoskin
