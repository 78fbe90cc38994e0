#include "core/io/volume_reader.h"

#include <array>
#include <cstring>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/dicom_series.h"
#include "core/io/file_bytes.h"
#include "core/io/normalise.h"
#include "core/io/stored_volume.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// A volume as it lies in its file or files, and its numbers.
struct Loaded {
  StoredVolume stored;
  std::vector<std::uint8_t> numbers;
  std::uintmax_t bytes = 0;
};

bool startsWith(const std::vector<std::uint8_t>& bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && !std::memcmp(bytes.data(), magic.data(), magic.size());
}

StoredVolume readHeader(const fs::path& path) {
  const std::vector<std::uint8_t> start = readBytes(path, 132);
  const std::string extension = lowerExtension(path);
  if (startsWith(start, "NRRD")) return readNrrdHeader(path);
  if (startsWith(start, "# vtk DataFile")) return readVtkHeader(path);
  if (extension == ".mha" || extension == ".mhd") return readMetaHeader(path);
  if (extension == ".nii" || extension == ".nii.gz") return readNiftiHeader(path);
  require(!startsWith(start, "KRETZFILE"),
          "{} is a GE Kretz file, which is not read yet; export it as NRRD with 3D Slicer.", path.string());
  throw Error(
      fmt::format("The format of {} is not known; use NRRD, MetaImage, NIfTI, VTK or DICOM.", path.string()));
}

Loaded load(const fs::path& path, const Progress& progress) {
  Loaded loaded;
  if (fs::is_directory(path) || isDicom(path)) {
    StoredSeries series = readDicomSeries(path, progress);
    checkGeometry(series.stored, path);
    return {std::move(series.stored), std::move(series.numbers), series.bytes};
  }
  loaded.stored = readHeader(path);
  checkStored(loaded.stored, path);
  loaded.bytes = fileSize(path) + (loaded.stored.dataFile == path ? 0 : fileSize(loaded.stored.dataFile));
  loaded.numbers = readNumbers(loaded.stored, progress);
  return loaded;
}

int timeStepsOf(const StoredVolume& stored) {
  return stored.timeIsFastest ? stored.components : stored.timeSteps;
}

}  // namespace

Scan readScan(const fs::path& path, const Progress& progress) {
  const Loaded loaded = load(path, progress.part(0, 0.6));
  NormalisedVolume normalised = normalise(loaded.stored, loaded.numbers, progress.part(0.6, 1));
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(std::move(normalised.volume));
  scan.originalMin = normalised.originalMin;
  scan.originalMax = normalised.originalMax;
  scan.originalType = numberTypeName(loaded.stored.type);
  scan.spacingKnown = loaded.stored.spacingKnown;
  scan.beam = loaded.stored.beam;
  scan.key = scanKey(*scan.volume, scan.beam);
  if (const int steps = timeStepsOf(loaded.stored); steps > 1)
    log(LogLevel::info,
        fmt::format("{} has {} time steps; the first is used.", path.filename().string(), steps));
  return scan;
}

VolumeInfo readVolumeInfo(const fs::path& path, const Progress& progress) {
  const Loaded loaded = load(path, progress.part(0, 0.6));
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
