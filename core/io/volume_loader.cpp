#include "core/io/volume_loader.h"

#include "core/base/error.h"
#include "core/io/dicom/dicom_series.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/headers/declared_volume.h"
#include "core/io/scanners/kretz_file.h"
#include "core/io/scanners/raw_file.h"
#include "core/io/scanners/toshiba_file.h"
#include "core/io/scanners/voreen_dat.h"
#include "core/io/scanners/voreen_vvd.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// A file of which was told what is in it needs no name and no mark, but one that has a mark is what that says.
FileFormat formatOf(const fs::path& path, const RawOptions& raw) {
  const std::vector<std::uint8_t> start = readBytes(path, 132);
  if (isTold(raw) && !hasMark(start)) {
    const FileFormat named = formatNamed(FileKind::readVolume, path).value_or(FileFormat::raw);
    if (named == FileFormat::raw || named == FileFormat::kretz) return FileFormat::raw;
  }
  return volumeFormat(path, start);
}

bool isVvd(const fs::path& path) { return lowerExtension(path) == ".vvd"; }

void requireOneVolume(const ReadOptions& options, const fs::path& path) {
  require(options.volume <= 1, "{} holds one volume; there is no volume {} (scan.volume).", path.string(),
          options.volume);
}

}  // namespace

LoadedVolume loadVolume(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  if (!isTold(options.raw) && isToshiba(path)) {
    requireOneVolume(options, path);
    return readToshiba(path, options, progress);
  }
  const FileFormat format = fs::is_directory(path) ? FileFormat::dicom : formatOf(path, options.raw);
  if (format == FileFormat::dicom) {
    LoadedVolume series = readDicomSeries(path, options, progress);
    checkGeometry(series.stored, path);
    return series;
  }
  if (format == FileFormat::kretz) return readKretzFile(path, options, progress);
  if (format == FileFormat::voreen && isVvd(path)) return readVoreenVvd(path, options, progress);
  requireOneVolume(options, path);
  if (format == FileFormat::voreen) return readVoreenDat(path, options, progress);
  if (format == FileFormat::raw) return readRawFile(path, options, progress);
  return readDeclared(format, path, options.time, progress);
}

std::vector<VolumeEntry> volumesIn(const fs::path& path, const ReadOptions& options,
                                   const Progress& progress) {
  if (!isTold(options.raw) && isToshiba(path)) return {};
  const FileFormat format = fs::is_directory(path) ? FileFormat::dicom : formatOf(path, options.raw);
  if (format == FileFormat::dicom) return dicomVolumes(path, progress);
  if (format == FileFormat::kretz) return kretzVolumes(readBytes(path), path);
  if (format == FileFormat::voreen && isVvd(path)) return vvdVolumes(path);
  return {};
}

}  // namespace sonoskin
