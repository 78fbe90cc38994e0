#include "core/io/scanners/voreen_vvd.h"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/scanners/raw_numbers.h"
#include "core/io/scanners/vvd_header.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

glm::ivec3 dimsOf(const VvdVolume& volume, const fs::path& path) {
  for (int a = 0; a < 3; ++a)
    require(volume.dims[a] >= 2 && volume.dims[a] <= 65535 && volume.dims[a] == std::floor(volume.dims[a]),
            "{} gives {} voxels along one axis; 2 to 65535 are possible.", path.string(), volume.dims[a]);
  return glm::ivec3(volume.dims);
}

// "uint8", or "Vector3(uint8)" for colours.
std::optional<std::pair<NumberType, int>> formatOf(std::string_view format) {
  int components = 1;
  if (format.starts_with("Vector") && format.size() > 8 && format[7] == '(' && format.ends_with(')')) {
    components = format[6] - '0';
    format = format.substr(8, format.size() - 9);
    if (components != 3 && components != 4) return {};
  }
  if (format == "float") format = "float32";
  if (format == "double") format = "float64";
  const auto names = enumNames(NumberType{});
  for (std::size_t t = 0; t < names.size(); ++t)
    if (format == names[t]) return std::pair(NumberType(t), components);
  return {};
}

// The corner and the axes of the voxels, after what the metadata do to them.
void place(const VvdVolume& volume, StoredVolume& stored) {
  Geometry& g = stored.geometry;
  stored.spacingKnown = volume.spacing.has_value();
  if (volume.spacing) g.spacing = *volume.spacing;
  g.origin = volume.offset.value_or(glm::dvec3(0));
  if (!volume.transformation) return;
  const glm::dmat4& m = *volume.transformation;
  g.origin = glm::dvec3(m * glm::dvec4(g.origin, 1));
  for (int a = 0; a < 3; ++a) {
    const double length = glm::length(glm::dvec3(m[a]));
    g.direction[a] = glm::dvec3(m[a]) / length;
    g.spacing[a] *= length;
  }
}

const VvdVolume& chosen(const std::vector<VvdVolume>& volumes, const ReadOptions& options,
                        const fs::path& path) {
  if (volumes.size() > 1 && options.volume == 0)
    throw Error(fmt::format("{} holds {} volumes; choose one with scan.volume: {}.", path.string(),
                            volumes.size(), entriesText(vvdVolumes(path))));
  require(options.volume <= int(volumes.size()), "{} has {} volume{}; there is no volume {} (scan.volume).",
          path.string(), volumes.size(), volumes.size() == 1 ? "" : "s", options.volume);
  return volumes[std::size_t(std::max(options.volume, 1) - 1)];
}

}  // namespace

LoadedVolume readVoreenVvd(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.update(0);
  const std::vector<VvdVolume> volumes = readVvdHeader(path);
  const VvdVolume& volume = chosen(volumes, options, path);
  const auto format = formatOf(volume.format);
  require(format.has_value(),
          "{} has numbers of a format that is not known here; save it as uint8, uint16 or float.",
          path.string());
  LoadedVolume loaded;
  StoredVolume& stored = loaded.stored;
  stored.format = "Voreen .vvd";
  stored.type = format->first;
  stored.components = format->second;
  stored.geometry.dims = dimsOf(volume, path);
  place(volume, stored);
  checkTime(options.time, 1, path);
  RawNumbers numbers;
  numbers.file = besideHeader(path, volume.file);
  numbers.type = stored.type;
  numbers.frame = countNumbers(stored.geometry.dims, stored.components, path);
  checkGeometry(stored, path);
  loaded.numbers = readNumbers(numbers, path);
  loaded.bytes = fileSize(path) + fileSize(numbers.file);
  progress.update(1);
  return loaded;
}

std::vector<VolumeEntry> vvdVolumes(const fs::path& path) {
  std::vector<VolumeEntry> entries;
  const std::vector<VvdVolume> volumes = readVvdHeader(path);
  if (volumes.size() < 2) return entries;
  for (const VvdVolume& volume : volumes) {
    VolumeEntry entry;
    entry.dims = dimsOf(volume, path);
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace sonoskin
