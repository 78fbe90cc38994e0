#include "core/io/volume_loader.h"

#include <cstring>

#include "core/base/error.h"
#include "core/io/dicom_series.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/itk_files.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

FileFormat formatOf(const fs::path& path) {
  const std::vector<std::uint8_t> start = readBytes(path, 132);
  constexpr std::string_view kKretz = "KRETZFILE";
  require(start.size() < kKretz.size() || std::memcmp(start.data(), kKretz.data(), kKretz.size()) != 0,
          "{} is a GE Kretz file, which is not read yet; export it as NRRD with 3D Slicer.", path.string());
  return volumeFormat(path, start);
}

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
  require(options.volume <= 1, "{} holds one volume; there is no volume {} (scan.volume).", path.string(),
          options.volume);
  const DeclaredData data = declaredData(format, path);
  std::vector<std::uint8_t> unpacked = checkData(data, path);
  return readWithItk(format, path, data, std::move(unpacked), options.time, progress);
}

std::vector<VolumeEntry> volumesIn(const fs::path& path, const Progress& progress) {
  const FileFormat format = fs::is_directory(path) ? FileFormat::dicom : formatOf(path);
  return format == FileFormat::dicom ? dicomVolumes(path, progress) : std::vector<VolumeEntry>();
}

}  // namespace sonoskin
