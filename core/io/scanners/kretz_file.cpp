#include "core/io/scanners/kretz_file.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/scanners/kretz_geometry.h"
#include "core/io/scanners/kretz_records.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// Bits 0F00 of an element are the volume's number.
constexpr int kMostVolumes = 16;

void refusePacked(const KretzRecords& records) {
  require(
      !records.packed(),
      "{} is packed by GE's wavelets, which no open program can unpack; open it in GE 4D View and save it "
      "again with wavelet compression None, or as VOL Cartesian, uncompressed.",
      records.path().string());
}

// Voxels: where those of one volume lie.
//   frames  of all time steps, one after another
struct Voxels {
  std::span<const std::uint8_t> frames;
  std::size_t bytesPerNumber = 1;
  int timeSteps = 1;
};

bool holdsVolume(const KretzRecords& records, int v) {
  return records.has(kretzTag(0xD000, 0x0001, v)) || records.has(kretzTag(0xD600, 0x0001, v));
}

std::vector<int> volumesOf(const KretzRecords& records) {
  std::vector<int> found;
  for (int v = 0; v < kMostVolumes; ++v)
    if (holdsVolume(records, v)) found.push_back(v);
  require(
      !found.empty(),
      "{} holds no voxels that can be read; if it is packed, open it in GE 4D View and save it again with "
      "wavelet compression None.",
      records.path().string());
  return found;
}

std::size_t bytesPerNumber(std::uint64_t bytes, std::uint64_t numbers, const fs::path& path) {
  require(bytes == numbers || bytes == 2 * numbers,
          "{} says that it has {} voxels, but holds {} bytes of them; get a fresh copy.", path.string(),
          numbers, bytes);
  return bytes == numbers ? 1 : 2;
}

// All steps lie in D600,0001 of a recording in time, of which D000,0001 is one again.
Voxels voxelsIn(const KretzRecords& records, int v, std::uint64_t numbers) {
  const fs::path& path = records.path();
  const auto one = records.bytesOf(kretzTag(0xD000, 0x0001, v));
  const auto all = records.bytesOf(kretzTag(0xD600, 0x0001, v));
  const auto told = records.knownWholeOf(kretzTag(0xD400, 0x0001, v));
  Voxels voxels;
  if (!one.empty()) voxels.bytesPerNumber = bytesPerNumber(one.size(), numbers, path);
  if (all.empty()) {
    require(!one.empty(), "{} holds no voxels; get a fresh copy.", path.string());
    voxels.frames = one;
    if (told.value_or(1) > 1)
      log(LogLevel::warning, fmt::format("The file says that it has {} time steps, but holds one.", *told));
    return voxels;
  }
  if (one.empty() && told && all.size() == 2 * numbers * *told) voxels.bytesPerNumber = 2;
  const std::uint64_t frame = numbers * voxels.bytesPerNumber, steps = all.size() / frame;
  require(steps >= 1 && steps <= 65536 && steps * frame == all.size() && (!told || *told == steps),
          "{} holds {} bytes of time steps of {} bytes, which do not fit together; get a fresh copy.",
          path.string(), all.size(), frame);
  voxels.frames = all;
  voxels.timeSteps = int(steps);
  return voxels;
}

std::string_view contentOf(int v) {
  constexpr std::string_view names[] = {"grey", "colour flow", "power Doppler"};
  return v < 3 ? names[v] : "of another kind";
}

int chosenVolume(const std::vector<int>& volumes, const ReadOptions& options, const fs::path& path) {
  require(options.volume >= 0 && options.volume <= int(volumes.size()),
          "{} has {} volume{}; there is no volume {} (scan.volume).", path.string(), volumes.size(),
          volumes.size() == 1 ? "" : "s", options.volume);
  if (options.volume > 0) return volumes[std::size_t(options.volume - 1)];
  if (volumes.size() > 1)
    log(LogLevel::info, fmt::format("The file holds {} volumes; the {} one is used; scan.volume chooses.",
                                    volumes.size(), contentOf(volumes.front())));
  return volumes.front();
}

std::uint64_t numbersOf(const glm::ivec3& dims) {
  return std::uint64_t(dims.x) * std::uint64_t(dims.y) * std::uint64_t(dims.z);
}

VolumeEntry entryOf(const KretzRecords& records, int v) {
  VolumeEntry entry;
  entry.dims = kretzDims(records, v);
  entry.timeSteps = voxelsIn(records, v, numbersOf(entry.dims)).timeSteps;
  entry.modality = "US";
  return entry;
}

}  // namespace

LoadedVolume kretzVolume(std::span<const std::uint8_t> file, const ReadOptions& options,
                         const fs::path& path) {
  const KretzRecords records(file, path);
  refusePacked(records);
  const int v = chosenVolume(volumesOf(records), options, path);
  LoadedVolume loaded;
  StoredVolume& stored = loaded.stored;
  stored.format = "GE Kretz";
  stored.modality = "US";
  describeKretz(records, v, stored);
  const std::uint64_t numbers = numbersOf(stored.geometry.dims);
  const Voxels voxels = voxelsIn(records, v, numbers);
  checkTime(options.time, voxels.timeSteps, path);
  stored.type = voxels.bytesPerNumber == 1 ? NumberType::uint8 : NumberType::uint16;
  stored.timeSteps = voxels.timeSteps;
  const std::size_t frame = std::size_t(numbers) * voxels.bytesPerNumber;
  const auto bytes = voxels.frames.subspan(frame * std::size_t(options.time - 1), frame);
  loaded.numbers.assign(bytes.begin(), bytes.end());
  return loaded;
}

std::vector<VolumeEntry> kretzVolumes(std::span<const std::uint8_t> file, const fs::path& path) {
  const KretzRecords records(file, path);
  refusePacked(records);
  std::vector<VolumeEntry> entries;
  const std::vector<int> volumes = volumesOf(records);
  if (volumes.size() < 2) return entries;
  for (const int v : volumes) {
    VolumeEntry entry = entryOf(records, v);
    entry.modality += fmt::format(", {}", contentOf(v));
    entries.push_back(entry);
  }
  return entries;
}

VolumeEntry kretzEntry(std::span<const std::uint8_t> file, const fs::path& path) {
  const KretzRecords records(file, path);
  refusePacked(records);
  return entryOf(records, volumesOf(records).front());
}

LoadedVolume readKretzFile(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.update(0);
  const std::vector<std::uint8_t> file = readBytes(path);
  progress.update(0.5);
  LoadedVolume loaded = kretzVolume(file, options, path);
  loaded.bytes = file.size();
  progress.update(1);
  return loaded;
}

}  // namespace sonoskin
