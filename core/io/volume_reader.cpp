#include "core/io/volume_reader.h"

#include <cstring>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/dicom_series.h"
#include "core/io/file_bytes.h"
#include "core/io/itk_files.h"
#include "core/io/normalise.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

bool startsWith(const std::vector<std::uint8_t>& bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && !std::memcmp(bytes.data(), magic.data(), magic.size());
}

VolumeFormat formatOf(const fs::path& path) {
  const std::vector<std::uint8_t> start = readBytes(path, 132);
  const std::string extension = lowerExtension(path);
  if (startsWith(start, "NRRD")) return VolumeFormat::nrrd;
  if (startsWith(start, "# vtk DataFile")) return VolumeFormat::vtk;
  if (extension == ".mha" || extension == ".mhd") return VolumeFormat::meta;
  if (extension == ".nii" || extension == ".nii.gz") return VolumeFormat::nifti;
  require(!startsWith(start, "KRETZFILE"),
          "{} is a GE Kretz file, which is not read yet; export it as NRRD with 3D Slicer.", path.string());
  throw Error(
      fmt::format("The format of {} is not known; use NRRD, MetaImage, NIfTI, VTK or DICOM.", path.string()));
}

DeclaredData declaredData(VolumeFormat format, const fs::path& path) {
  switch (format) {
    case VolumeFormat::nrrd:
      return nrrdData(path);
    case VolumeFormat::meta:
      return metaData(path);
    case VolumeFormat::nifti:
      return niftiData(path);
    case VolumeFormat::vtk:
      return vtkData(path);
  }
  return {};
}

LoadedVolume load(const fs::path& path, const Progress& progress) {
  if (fs::is_directory(path) || isDicom(path)) {
    LoadedVolume series = readDicomSeries(path, progress);
    checkGeometry(series.stored, path);
    return series;
  }
  const VolumeFormat format = formatOf(path);
  const DeclaredData data = declaredData(format, path);
  checkData(data, path);
  return readWithItk(format, path, data, progress);
}

int timeStepsOf(const StoredVolume& stored) {
  return stored.timeIsFastest ? stored.components : stored.timeSteps;
}

}  // namespace

Scan readScan(const fs::path& path, const Progress& progress) {
  const LoadedVolume loaded = load(path, progress.part(0, 0.6));
  NormalisedVolume normalised = normalise(loaded.stored, loaded.numbers, progress.part(0.6, 1));
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(std::move(normalised.volume));
  scan.originalMin = normalised.originalMin;
  scan.originalMax = normalised.originalMax;
  scan.originalType = numberTypeName(loaded.stored.type);
  scan.spacingKnown = loaded.stored.spacingKnown;
  scan.beam = loaded.stored.beam;
  scan.modality = loaded.stored.modality;
  scan.key = scanKey(*scan.volume, scan.beam);
  if (const int steps = timeStepsOf(loaded.stored); steps > 1)
    log(LogLevel::info,
        fmt::format("{} has {} time steps; the first is used.", path.filename().string(), steps));
  return scan;
}

VolumeInfo readVolumeInfo(const fs::path& path, const Progress& progress) {
  const LoadedVolume loaded = load(path, progress.part(0, 0.6));
  const NormalisedVolume normalised = normalise(loaded.stored, loaded.numbers, progress.part(0.6, 1));
  VolumeInfo info;
  info.format = loaded.stored.format;
  info.geometry = loaded.stored.geometry;
  info.spacingKnown = loaded.stored.spacingKnown;
  info.numberType = numberTypeName(loaded.stored.type);
  info.components = loaded.stored.timeIsFastest ? 1 : loaded.stored.components;
  info.timeSteps = timeStepsOf(loaded.stored);
  info.valueMin = normalised.valueMin;
  info.valueMax = normalised.valueMax;
  info.bytes = loaded.bytes;
  info.beam = loaded.stored.beam;
  return info;
}

}  // namespace sonoskin
