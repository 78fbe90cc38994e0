#include "core/io/scanners/raw_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/scanners/raw_numbers.h"
#include "core/io/scanners/toshiba_file.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

std::vector<double> evenAngles(int count, double degrees) {
  std::vector<double> angles(std::size_t(count), 0.0);
  for (int n = 0; n < count; ++n)
    angles[std::size_t(n)] = glm::radians(degrees) * (double(n) / double(count - 1) - 0.5);
  return angles;
}

SampleGrid sectorOf(const RawOptions& o) {
  SweptGrid grid;
  grid.samples = o.dims[0];
  grid.sampleDistance = o.spacing[0];
  grid.firstRadius = o.firstRadius;
  grid.axisDepth = o.axisDepth;
  grid.fan = evenAngles(o.dims[1], o.fanAngle);
  grid.sweep = evenAngles(o.dims[2], o.sweepAngle);
  return grid;
}

SampleGrid pyramidOf(const RawOptions& o) {
  PyramidGrid grid;
  grid.dims = {o.dims[0], o.dims[1], o.dims[2]};
  grid.lateral = o.spacing[0];
  grid.depth = o.spacing[1];
  grid.aperture = o.aperture;
  grid.growth = 2 * std::tan(0.5 * glm::radians(o.sweepAngle));
  return grid;
}

[[noreturn]] void refuse(const std::string& sentence) { throw Error(sentence, Error::Kind::usage); }

void checkTold(const RawOptions& o, const fs::path& path) {
  if (!isTold(o)) {
    std::vector<std::string> guesses;
    for (const RawGuess& guess : guessRaw(fileSize(path)))
      if (guesses.size() < 3)
        guesses.push_back(fmt::format("{}x{}x{} of {}", guess.dims[0], guess.dims[1], guess.dims[2],
                                      enumNames(guess.type)[std::size_t(guess.type)]));
    refuse(fmt::format(
        "{} has no header that says what is in it; give raw.dims, raw.type and raw.spacing, and "
        "raw.grid where it was not sampled on voxels{}{}.",
        path.string(), guesses.empty() ? "" : "; it has the size of ", fmt::join(guesses, ", or ")));
  }
  const auto given = std::ranges::count_if(o.spacing, [](double mm) { return mm > 0; });
  if (o.grid == RawGrid::cartesian && given != 0 && given != 3)
    refuse("One number of raw.spacing is 0; give all three, or none if the spacing is unknown.");
  if (o.grid == RawGrid::sector && !(o.spacing[0] > 0 && o.fanAngle > 0 && o.sweepAngle > 0))
    refuse(
        "The sector has no size; give the first of raw.spacing, raw.firstRadius, raw.axisDepth, raw.fanAngle "
        "and "
        "raw.sweepAngle.");
  if (o.grid == RawGrid::pyramid && !(o.spacing[0] > 0 && o.spacing[1] > 0 && o.aperture + o.sweepAngle > 0))
    refuse("The pyramid has no size; give the first two of raw.spacing, raw.aperture and raw.sweepAngle.");
}

void describe(const RawOptions& o, StoredVolume& stored) {
  stored.format = "raw numbers";
  stored.type = o.type;
  stored.timeSteps = o.timeSteps;
  stored.geometry.dims = {o.dims[0], o.dims[1], o.dims[2]};
  if (o.grid == RawGrid::cartesian) {
    stored.spacingKnown = o.spacing[0] > 0 && o.spacing[1] > 0 && o.spacing[2] > 0;
    if (stored.spacingKnown) stored.geometry.spacing = {o.spacing[0], o.spacing[1], o.spacing[2]};
    return;
  }
  stored.grid = o.grid == RawGrid::sector ? sectorOf(o) : pyramidOf(o);
  stored.geometry.spacing = glm::dvec3(o.spacing[0]);
  const auto fault = gridFault(*stored.grid);
  if (fault) refuse(fmt::format("The grid that raw.grid and its numbers tell cannot be: {}.", *fault));
}

}  // namespace

LoadedVolume readRawFile(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  const RawOptions& o = options.raw;
  checkTold(o, path);
  const glm::ivec3 dims(o.dims[0], o.dims[1], o.dims[2]);
  RawNumbers numbers;
  numbers.file = path;
  numbers.type = o.type;
  numbers.byteOrder = o.byteOrder;
  numbers.frame = countNumbers(dims, 1, path);
  numbers.header = o.header;
  numbers.timeSteps = o.timeSteps;
  numbers.step = options.time;
  LoadedVolume loaded;
  describe(o, loaded.stored);
  progress.update(0.1);
  loaded.numbers = readNumbers(numbers, path);
  loaded.bytes = fileSize(path);
  if (!loaded.stored.grid) checkGeometry(loaded.stored, path);
  progress.update(1);
  return loaded;
}

bool needsRawOptions(const fs::path& path, const RawOptions& options) {
  if (isTold(options) || formatNamed(FileKind::readVolume, path) != FileFormat::raw) return false;
  return !isToshiba(path) && !hasMark(readBytes(path, 132));
}

std::vector<RawGuess> guessRaw(std::uintmax_t bytes) {
  std::vector<RawGuess> guesses;
  constexpr NumberType types[] = {NumberType::uint8, NumberType::uint16, NumberType::float32};
  for (const NumberType type : types) {
    if (bytes % numberTypeBytes(type) != 0) continue;
    const double numbers = double(bytes / numberTypeBytes(type));
    const int edge = int(std::lround(std::cbrt(std::min(numbers, 1e12))));
    if (edge >= 16 && double(edge) * edge * edge == numbers) guesses.push_back({{edge, edge, edge}, type});
  }
  for (const NumberType type : types)
    for (const std::uintmax_t edge : {256u, 512u, 128u, 1024u}) {
      const std::uintmax_t picture = edge * edge * numberTypeBytes(type), pictures = bytes / picture;
      if (bytes % picture == 0 && pictures >= 16 && pictures <= 1024 && pictures != edge)
        guesses.push_back({{int(edge), int(edge), int(pictures)}, type});
    }
  return guesses;
}

}  // namespace sonoskin
