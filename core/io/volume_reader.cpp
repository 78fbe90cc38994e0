#include "core/io/volume_reader.h"

#include <fmt/format.h>

#include "core/base/log.h"
#include "core/io/loaded_scan.h"
#include "core/io/reader_process.h"
#include "core/io/reader_wire.h"
#include "core/io/volume_loader.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// In a process of its own, where there are any.
LoadedVolume load(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  if (!readersRun()) return loadVolume(path, options, progress);
  return volumeFrom(readApart({ReaderTask::volume, options}, path, progress).bytes(), path);
}

// What of a file is used where it holds more. Does not name it: its name may be a patient's.
void noteChoices(const StoredVolume& stored, bool isScan) {
  if (stored.timeSteps > 1 && !isScan)  // of a scan the caller knows whether others are used too
    log(LogLevel::info, fmt::format("The mask has {} time steps; the first is used.", stored.timeSteps));
  if (stored.components > 1)
    log(LogLevel::info, fmt::format("The {} is in colour; its grey is used.", isScan ? "scan" : "mask"));
}

Scan read(const fs::path& path, const ReadOptions& options, const Progress& progress, bool isScan) {
  LoadedVolume loaded = load(path, options, progress.part(0, 0.6));
  noteChoices(loaded.stored, isScan);
  return scanOf(std::move(loaded), options, isScan, progress.part(0.6, 1)).scan;
}

}  // namespace

Scan readScan(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  return read(path, options, progress, true);
}

std::vector<VolumeEntry> listVolumes(const fs::path& path, const ReadOptions& options,
                                     const Progress& progress) {
  if (!readersRun()) return volumesIn(path, options, progress);
  return entriesFrom(readApart({ReaderTask::list, options}, path, progress).bytes(), path);
}

Scan readMarks(const fs::path& path, const RawOptions& raw, const Progress& progress) {
  ReadOptions options;
  options.raw = raw;
  return read(path, options, progress, false);
}

VolumeInfo readVolumeInfo(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  LoadedVolume loaded = load(path, options, progress.part(0, 0.6));
  VolumeInfo info;
  info.format = loaded.stored.format;
  info.components = loaded.stored.components;
  info.bytes = loaded.bytes;
  info.grid = loaded.stored.grid;
  const auto [scan, valueMin, valueMax] = scanOf(std::move(loaded), options, true, progress.part(0.6, 1));
  info.geometry = scan.volume->geometry;
  info.spacingKnown = scan.spacingKnown;
  info.numberType = scan.originalType;
  info.timeSteps = scan.timeSteps;
  info.stepSeconds = scan.stepSeconds;
  info.valueMin = valueMin;
  info.valueMax = valueMax;
  info.beam = scan.beam;
  info.key = scan.key;
  return info;
}

}  // namespace sonoskin
