#include "core/io/volume_loader.h"

#include <cstring>

#include "core/base/error.h"
#include "core/io/dicom_series.h"
#include "core/io/file_bytes.h"
#include "core/io/itk_files.h"

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

}  // namespace

LoadedVolume loadVolume(const fs::path& path, const Progress& progress) {
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

}  // namespace sonoskin
