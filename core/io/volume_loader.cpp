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

LoadedVolume readVoreen(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  return lowerExtension(path) == ".vvd" ? readVoreenVvd(path, options, progress)
                                        : readVoreenDat(path, options, progress);
}

}  // namespace

LoadedVolume loadVolume(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  if (!isTold(options.raw) && isToshiba(path)) return readToshiba(path, options, progress);
  const FileFormat format = fs::is_directory(path) ? FileFormat::dicom : formatOf(path, options.raw);
  if (format == FileFormat::dicom) {
    LoadedVolume series = readDicomSeries(path, options, progress);
    checkGeometry(series.stored, path);
    return series;
  }
  if (format == FileFormat::kretz) return readKretzFile(path, options, progress);
  if (format == FileFormat::voreen) return readVoreen(path, options, progress);
  if (format == FileFormat::raw) return readRawFile(path, options, progress);
  require(options.volume <= 1, "{} holds one volume; there is no volume {} (scan.volume).", path.string(),
          options.volume);
  return readDeclared(format, path, options.time, progress);
}

std::vector<VolumeEntry> volumesIn(const fs::path& path, const Progress& progress) {
  if (isToshiba(path)) return {};
  if (!fs::is_directory(path) && !formatNamed(FileKind::readVolume, path) && !hasMark(readBytes(path, 132)))
    return {};  // of which may be told what is in it
  const FileFormat format = fs::is_directory(path) ? FileFormat::dicom : formatOf(path, {});
  if (format == FileFormat::dicom) return dicomVolumes(path, progress);
  if (format == FileFormat::kretz) return kretzVolumes(readBytes(path), path);
  if (format == FileFormat::voreen && lowerExtension(path) == ".vvd") return vvdVolumes(path);
  return {};
}

}  // namespace sonoskin
