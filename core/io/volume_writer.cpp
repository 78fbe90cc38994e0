#include "core/io/volume_writer.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/itk_files.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

VolumeFormat formatOf(const fs::path& path) {
  const std::string extension = lowerExtension(path);
  if (extension == ".nrrd") return VolumeFormat::nrrd;
  if (extension == ".mha") return VolumeFormat::meta;
  if (extension == ".nii.gz") return VolumeFormat::nifti;
  if (extension == ".vtk") return VolumeFormat::vtk;
  throw Error(fmt::format("{} cannot be written: the name of a volume ends in {}.", path.string(),
                          fmt::join(volumeExtensions(), ", ")),
              Error::Kind::usage);
}

template <class T>
void write(const fs::path& path, const Volume<T>& volume, const std::optional<Beam>& beam,
           const Progress& progress) {
  const VolumeFormat format = formatOf(path);
  const Geometry& g = volume.geometry;
  if (format == VolumeFormat::vtk && g.direction != glm::dmat3(1))
    throw Error(
        fmt::format("{} would lose the direction of the volume's axes; write .nrrd instead.", path.string()),
        Error::Kind::usage);
  require(g.dims.x > 0 && g.dims.y > 0 && g.dims.z > 0 && volume.data.size() == g.voxels(),
          "There is no volume to write to {}.", path.string());
  StoredVolume stored;
  stored.geometry = g;
  stored.type = std::is_same_v<T, float> ? NumberType::float32 : NumberType::uint8;
  stored.beam = beam;
  if (stored.type == NumberType::float32) stored.unitRange = {0.0, 1.0};
  writeWithItk(format, path, stored, volume.data.data(), progress);
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
