#include "core/io/itk_files.h"

#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVTKImageIO.h>

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

itk::ImageIOBase::Pointer makeIo(FileFormat format) {
  itk::Object::GlobalWarningDisplayOff();  // warnings may quote the file, and would go to the terminal
  switch (format) {
    case FileFormat::nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case FileFormat::meta:
      return itk::MetaImageIO::New().GetPointer();
    case FileFormat::nifti:
      return itk::NiftiImageIO::New().GetPointer();
    default:
      return itk::VTKImageIO::New().GetPointer();
  }
}

itk::ImageIORegion wholeRegion(const itk::ImageIOBase& io) {
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a) region.SetSize(a, io.GetDimensions(a));
  return region;
}

void setGeometry(itk::ImageIOBase& io, const Geometry& g) {
  io.SetNumberOfDimensions(3);
  for (unsigned a = 0; a < 3; ++a) {
    const glm::dvec3 axis = g.direction[int(a)];
    io.SetDimensions(a, std::size_t(g.dims[int(a)]));
    io.SetSpacing(a, g.spacing[int(a)]);
    io.SetOrigin(a, g.origin[int(a)]);
    io.SetDirection(a, std::vector<double>{axis.x, axis.y, axis.z});
  }
  io.SetIORegion(wholeRegion(io));
}

std::string text(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

void setKeys(itk::ImageIOBase& io, const StoredVolume& stored) {
  itk::MetaDataDictionary keys;
  const auto& range = stored.unitRange;
  const auto& beam = stored.beam;
  if (range)
    itk::EncapsulateMetaData<std::string>(keys, kRangeKey, fmt::format("{} {}", range->first, range->second));
  if (beam) itk::EncapsulateMetaData<std::string>(keys, kBeamAxisKey, text(beam->axis));
  if (beam) itk::EncapsulateMetaData<std::string>(keys, kBeamUpKey, text(beam->up));
  if (beam && beam->apex) itk::EncapsulateMetaData<std::string>(keys, kBeamApexKey, text(*beam->apex));
  io.SetMetaDataDictionary(keys);
}

// Whether a file holds all of a volume: ITK's writers do not tell when the disk is full.
bool holdsAll(FileFormat format, const fs::path& path, const void* numbers, std::size_t bytes) try {
  const itk::ImageIOBase::Pointer io = makeIo(format);
  io->SetFileName(path.string());
  io->ReadImageInformation();
  if (std::size_t(io->GetImageSizeInBytes()) != bytes) return false;
  io->SetIORegion(wholeRegion(*io));
  std::vector<std::uint8_t> read(bytes);
  io->Read(read.data());
  return std::memcmp(read.data(), numbers, bytes) == 0;
} catch (const itk::ExceptionObject&) {
  return false;
}

}  // namespace

void writeWithItk(FileFormat format, const fs::path& path, const StoredVolume& stored, const void* numbers,
                  const Progress& progress) {
  progress.update(0);
  const itk::ImageIOBase::Pointer io = makeIo(format);
  setGeometry(*io, stored.geometry);
  io->SetComponentType(stored.type == NumberType::uint8 ? itk::IOComponentEnum::UCHAR
                                                        : itk::IOComponentEnum::FLOAT);
  io->SetPixelType(itk::IOPixelEnum::SCALAR);
  io->SetNumberOfComponents(1);
  io->SetUseCompression(format != FileFormat::vtk);
  if (format == FileFormat::nrrd || format == FileFormat::meta) setKeys(*io, stored);
  const std::size_t bytes = stored.geometry.voxels() * (stored.type == NumberType::uint8 ? 1 : sizeof(float));
  writeAtomically(path, [&](const fs::path& temporary) {
    bool written = true;
    try {
      io->SetFileName(temporary.string());
      io->WriteImageInformation();
      io->Write(numbers);
    } catch (const itk::ExceptionObject&) {
      written = false;
    }
    progress.update(0.7);
    if (!written || !holdsAll(format, temporary, numbers, bytes))
      throw Error(
          fmt::format("{} could not be written; the disk may be full, make room or choose another place.",
                      path.string()),
          Error::Kind::system);
    progress.throwIfCancelled();
  });
  progress.update(1);
}

}  // namespace sonoskin
