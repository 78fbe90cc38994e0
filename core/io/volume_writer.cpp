#include "core/io/volume_writer.h"

#include <fmt/ranges.h>
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVTKImageIO.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

itk::ImageIOBase::Pointer makeIo(const fs::path& path) {
  const std::string extension = lowerExtension(path);
  if (extension == ".nrrd") return itk::NrrdImageIO::New().GetPointer();
  if (extension == ".mha") return itk::MetaImageIO::New().GetPointer();
  if (extension == ".nii.gz") return itk::NiftiImageIO::New().GetPointer();
  if (extension == ".vtk") return itk::VTKImageIO::New().GetPointer();
  throw Error(fmt::format("{} cannot be written: the name of a volume ends in {}.", path.string(),
                          fmt::join(volumeExtensions(), ", ")),
              Error::Kind::usage);
}

void setGeometry(itk::ImageIOBase& io, const Geometry& g) {
  io.SetNumberOfDimensions(3);
  itk::ImageIORegion region(3);
  for (unsigned a = 0; a < 3; ++a) {
    const glm::dvec3 axis = g.direction[int(a)];
    io.SetDimensions(a, std::size_t(g.dims[int(a)]));
    io.SetSpacing(a, g.spacing[int(a)]);
    io.SetOrigin(a, g.origin[int(a)]);
    io.SetDirection(a, std::vector<double>{axis.x, axis.y, axis.z});
    region.SetIndex(a, 0);
    region.SetSize(a, std::size_t(g.dims[int(a)]));
  }
  io.SetIORegion(region);
}

std::string text(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

void setKeys(itk::ImageIOBase& io, const std::optional<Beam>& beam, bool isFloat) {
  itk::MetaDataDictionary keys;
  if (isFloat) itk::EncapsulateMetaData<std::string>(keys, kRangeKey, "0 1");
  if (beam) itk::EncapsulateMetaData<std::string>(keys, kBeamAxisKey, text(beam->axis));
  if (beam) itk::EncapsulateMetaData<std::string>(keys, kBeamUpKey, text(beam->up));
  if (beam && beam->apex) itk::EncapsulateMetaData<std::string>(keys, kBeamApexKey, text(*beam->apex));
  io.SetMetaDataDictionary(keys);
}

template <class T>
void write(const fs::path& path, const Volume<T>& volume, const std::optional<Beam>& beam,
           const Progress& progress) {
  constexpr bool isFloat = std::is_same_v<T, float>;
  const itk::ImageIOBase::Pointer io = makeIo(path);
  const Geometry& g = volume.geometry;
  if (lowerExtension(path) == ".vtk" && g.direction != glm::dmat3(1))
    throw Error(
        fmt::format("{} would lose the direction of the volume's axes; write .nrrd instead.", path.string()),
        Error::Kind::usage);
  require(g.dims.x > 0 && g.dims.y > 0 && g.dims.z > 0 && volume.data.size() == g.voxels(),
          "There is no volume to write to {}.", path.string());
  progress.update(0);
  itk::Object::GlobalWarningDisplayOff();
  setGeometry(*io, g);
  io->SetComponentType(isFloat ? itk::IOComponentEnum::FLOAT : itk::IOComponentEnum::UCHAR);
  io->SetPixelType(itk::IOPixelEnum::SCALAR);
  io->SetNumberOfComponents(1);
  io->SetUseCompression(lowerExtension(path) != ".vtk");
  const std::string extension = lowerExtension(path);
  if (extension == ".nrrd" || extension == ".mha") setKeys(*io, beam, isFloat);
  writeAtomically(path, [&](const fs::path& temporary) {
    try {
      io->SetFileName(temporary.string());
      io->WriteImageInformation();
      io->Write(volume.data.data());
    } catch (const itk::ExceptionObject&) {
      throw Error(fmt::format("{} could not be written; is the disk full?", path.string()),
                  Error::Kind::system);
    }
    progress.throwIfCancelled();
  });
  progress.update(1);
}

}  // namespace

const std::vector<std::string>& volumeExtensions() {
  static const std::vector<std::string> extensions{".nrrd", ".mha", ".nii.gz", ".vtk"};
  return extensions;
}

void writeVolume(const fs::path& path, const Volume<float>& volume, const std::optional<Beam>& beam,
                 const Progress& progress) {
  write(path, volume, beam, progress);
}

void writeVolume(const fs::path& path, const Volume<std::uint8_t>& volume, const std::optional<Beam>& beam,
                 const Progress& progress) {
  write(path, volume, beam, progress);
}

void writeScan(const fs::path& path, const Scan& scan, const Progress& progress) {
  require(scan.volume != nullptr, "There is no volume to write to {}.", path.string());
  if (scan.originalType != "uint8") return writeVolume(path, *scan.volume, scan.beam, progress);
  Volume<std::uint8_t> bytes(scan.volume->geometry);
  std::transform(scan.volume->data.begin(), scan.volume->data.end(), bytes.data.begin(),
                 [](float v) { return std::uint8_t(std::lround(255 * std::clamp(v, 0.f, 1.f))); });
  writeVolume(path, bytes, scan.beam, progress);
}

}  // namespace sonoskin
