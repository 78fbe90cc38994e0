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
#include "core/io/file_bytes.h"
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

void guarded(const fs::path& path, const std::function<void()>& call) {
  callItk(call,
          fmt::format("{} holds no voxels that can be read: it is damaged, or of a kind that is not known "
                      "here; get a fresh copy, or save it in another format.",
                      path.string()));
}

// The keys of ours that ITK has found.
HeaderKeys ownKeys(const itk::ImageIOBase& io) {
  HeaderKeys keys;
  std::string value;
  for (const char* key : {kBeamAxisKey, kBeamUpKey, kBeamApexKey, kRangeKey})
    if (itk::ExposeMetaData(io.GetMetaDataDictionary(), key, value)) keys[key] = value;
  return keys;
}

StoredVolume describe(const itk::ImageIOBase& io, FileFormat format, const DeclaredData& data,
                      const fs::path& path) {
  StoredVolume stored = describedBy(io, path);
  stored.format = formatName(format);
  stored.spacingKnown = data.spacingKnown;
  stored.timeSteps = io.GetNumberOfDimensions() == 4 ? int(io.GetDimensions(3)) : 1;
  if (data.timeAxis >= 0) stored.timeSteps = std::exchange(stored.components, 1);
  const HeaderKeys keys = ownKeys(io);
  stored.beam = beamFromKeys(keys);
  stored.unitRange = rangeFromKeys(keys);
  // A NIfTI with a slope is read as float.
  const bool agree = io.GetNumberOfDimensions() <= 4 &&
                     std::uint64_t(io.GetImageSizeInComponents()) == numbersIn(data) &&
                     (format == FileFormat::nifti || io.GetComponentSize() == data.bytesPerNumber);
  require(agree, "{} has a header that contradicts itself; get a fresh copy.", path.string());
  return stored;
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

// Leaves one time step of all, which lie one after another, or side by side.
void keepStep(LoadedVolume& loaded, int time, bool sideBySide) {
  const std::size_t steps = std::size_t(loaded.stored.timeSteps), step = std::size_t(time) - 1;
  std::vector<std::uint8_t>& numbers = loaded.numbers;
  const std::size_t block = sideBySide ? numberTypeBytes(loaded.stored.type) : numbers.size() / steps;
  const std::size_t stride = sideBySide ? block * steps : numbers.size();
  std::size_t to = 0;
  for (std::size_t from = step * block; from < numbers.size(); from += stride, to += block)
    std::memmove(numbers.data() + to, numbers.data() + from, block);
  numbers.resize(to);
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

void callItk(const std::function<void()>& call, const std::string& sentence) {
  try {
    call();
  } catch (const itk::MemoryAllocationError&) {
    throw std::bad_alloc();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    throw Error(sentence);
  }
}

StoredVolume describedBy(const itk::ImageIOBase& io, const fs::path& path) {
  StoredVolume stored;
  const auto type = numberTypeOf(itk::ImageIOBase::GetComponentTypeAsString(io.GetComponentType()));
  require(type.has_value(),
          "{} has numbers of a type that is not known here; save it with whole numbers or as float.",
          path.string());
  stored.type = *type;
  stored.components = int(io.GetNumberOfComponents());
  Geometry& g = stored.geometry;
  for (unsigned a = 0; a < 3; ++a) {
    const bool given = a < io.GetNumberOfDimensions();
    g.dims[int(a)] = given ? int(std::min<std::size_t>(io.GetDimensions(a), 1u << 20)) : 1;
    if (!given) continue;
    g.spacing[int(a)] = io.GetSpacing(a);
    g.origin[int(a)] = io.GetOrigin(a);
    const std::vector<double> axis = io.GetDirection(a);
    for (std::size_t r = 0; r < std::min<std::size_t>(axis.size(), 3); ++r)
      g.direction[int(a)][int(r)] = axis[r] + 0.0;  // no -0
  }
  return stored;
}

LoadedVolume readWithItk(FileFormat format, const fs::path& path, const DeclaredData& data,
                         std::vector<std::uint8_t> unpacked, int time, const Progress& progress) {
  progress.update(0);
  const itk::ImageIOBase::Pointer io = makeIo(format);
  LoadedVolume loaded;
  io->SetFileName(path.string());
  guarded(path, [&] { io->ReadImageInformation(); });
  loaded.stored = describe(*io, format, data, path);
  checkGeometry(loaded.stored, path);
  checkTime(time, loaded.stored.timeSteps, path);
  io->SetIORegion(wholeRegion(*io));
  progress.update(0.1);
  const std::size_t bytes = std::size_t(io->GetImageSizeInBytes());
  // ITK would unpack them again; what it turns over, colours and lists, is left to it.
  const bool isPlain = io->GetNumberOfComponents() == 1;
  if (isPlain && unpacked.size() == bytes)
    loaded.numbers = std::move(unpacked);
  else
    guarded(path, [&] {
      loaded.numbers.resize(bytes);
      io->Read(loaded.numbers.data());
    });
  const bool sideBySide = data.timeAxis >= 0;
  keepStep(loaded, time, sideBySide);
  loaded.bytes = fileSize(path) + (data.file == path ? 0 : fileSize(data.file));
  progress.update(1);
  return loaded;
}

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
