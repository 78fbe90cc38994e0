#include "core/io/volume_reader.h"

#include <fmt/format.h>

#include "core/base/available_memory.h"
#include "core/base/log.h"
#include "core/io/normalise.h"
#include "core/io/reader_process.h"
#include "core/io/reader_wire.h"
#include "core/io/volume_loader.h"
#include "core/volume/scan_size.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// In a process of its own, where there are any.
LoadedVolume load(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  if (!readersRun()) return loadVolume(path, options, progress);
  return volumeFrom(readApart({ReaderTask::volume, options}, path, progress).bytes(), path);
}

// What of a file is used where it holds more. Does not name it: its name may be a patient's.
void noteChoices(const StoredVolume& stored, int time, const char* what) {
  if (stored.timeSteps > 1 && time == 1)
    log(LogLevel::info, fmt::format("The {} has {} time steps; the first is used.", what, stored.timeSteps));
  if (stored.components > 1) log(LogLevel::info, fmt::format("The {} is in colour; its grey is used.", what));
}

Scan read(const fs::path& path, const ReadOptions& options, const Progress& progress, bool isScan) {
  const LoadedVolume loaded = load(path, options, progress.part(0, 0.6));
  requireMemory(loaded.stored.geometry, kBytesToRead, availableMemory());
  NormalisedVolume normalised = normalise(loaded.stored, loaded.numbers, progress.part(0.6, 1), isScan);
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(std::move(normalised.volume));
  scan.originalMin = normalised.originalMin;
  scan.originalMax = normalised.originalMax;
  scan.originalType = numberTypeName(loaded.stored.type);
  scan.spacingKnown = loaded.stored.spacingKnown;
  scan.beam = loaded.stored.beam;
  scan.modality = loaded.stored.modality;
  scan.timeSteps = loaded.stored.timeSteps;
  scan.time = options.time;
  scan.stepSeconds = loaded.stored.stepSeconds;
  scan.key = scanKey(*scan.volume, scan.beam);
  noteChoices(loaded.stored, options.time, isScan ? "scan" : "mask");
  return scan;
}

}  // namespace

Scan readScan(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  return read(path, options, progress, true);
}

std::vector<VolumeEntry> listVolumes(const fs::path& path, const Progress& progress) {
  if (!readersRun()) return volumesIn(path, progress);
  return entriesFrom(readApart({ReaderTask::list, {}}, path, progress).bytes(), path);
}

Scan readMarks(const fs::path& path, const Progress& progress) { return read(path, {}, progress, false); }

VolumeInfo readVolumeInfo(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  const LoadedVolume loaded = load(path, options, progress.part(0, 0.6));
  const NormalisedVolume normalised = normalise(loaded.stored, loaded.numbers, progress.part(0.6, 1));
  VolumeInfo info;
  info.format = loaded.stored.format;
  info.geometry = loaded.stored.geometry;
  info.spacingKnown = loaded.stored.spacingKnown;
  info.numberType = numberTypeName(loaded.stored.type);
  info.components = loaded.stored.components;
  info.timeSteps = loaded.stored.timeSteps;
  info.stepSeconds = loaded.stored.stepSeconds;
  info.valueMin = normalised.valueMin;
  info.valueMax = normalised.valueMax;
  info.bytes = loaded.bytes;
  info.beam = loaded.stored.beam;
  info.key = scanKey(normalised.volume, info.beam);
  return info;
}

}  // namespace sonoskin
