#include "core/io/volume_loader.h"

#include "core/base/error.h"
#include "core/io/dicom_series.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/itk_files.h"
#include "core/io/kretz_file.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

FileFormat formatOf(const fs::path& path) { return volumeFormat(path, readBytes(path, 132)); }

DeclaredData declaredData(FileFormat format, const fs::path& path) {
  switch (format) {
    case FileFormat::nrrd:
      return nrrdData(path);
    case FileFormat::meta:
      return metaData(path);
    case FileFormat::nifti:
      return niftiData(path);
    default:
      return vtkData(path);
  }
}

}  // namespace

LoadedVolume loadVolume(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  const FileFormat format = fs::is_directory(path) ? FileFormat::dicom : formatOf(path);
  if (format == FileFormat::dicom) {
    LoadedVolume series = readDicomSeries(path, options, progress);
    checkGeometry(series.stored, path);
    return series;
  }
  if (format == FileFormat::kretz) return readKretzFile(path, options, progress);
  require(options.volume <= 1, "{} holds one volume; there is no volume {} (scan.volume).", path.string(),
          options.volume);
  const DeclaredData data = declaredData(format, path);
  std::vector<std::uint8_t> unpacked = checkData(data, path);
  return readWithItk(format, path, data, std::move(unpacked), options.time, progress);
}

std::vector<VolumeEntry> volumesIn(const fs::path& path, const Progress& progress) {
  const FileFormat format = fs::is_directory(path) ? FileFormat::dicom : formatOf(path);
  if (format == FileFormat::dicom) return dicomVolumes(path, progress);
  if (format == FileFormat::kretz) return kretzVolumes(readBytes(path), path);
  return {};
}

}  // namespace sonoskin
