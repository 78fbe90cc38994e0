#include "core/io/volume_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/io/file_formats.h"
#include "core/io/itk_files.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

template <class T>
void write(const fs::path& path, const Volume<T>& volume, const std::optional<Beam>& beam,
           const Progress& progress) {
  const FileFormat format = requireFormat(FileKind::writtenVolume, path);
  const Geometry& g = volume.geometry;
  if (format == FileFormat::vtk && g.direction != glm::dmat3(1))
    throw Error(
        fmt::format("{} would lose the direction of the volume's axes; write .nrrd instead.", path.string()),
        Error::Kind::usage);
  require(g.dims.x > 0 && g.dims.y > 0 && g.dims.z > 0 && volume.data.size() == g.voxels(),
          "There is no volume to write to {}; open one first.", path.string());
  StoredVolume stored;
  stored.geometry = g;
  stored.type = std::is_same_v<T, float> ? NumberType::float32 : NumberType::uint8;
  stored.beam = beam;
  if (stored.type == NumberType::float32) stored.unitRange = {0.0, 1.0};
  writeWithItk(format, path, stored, volume.data.data(), progress);
}

}  // namespace

void writeVolume(const fs::path& path, const Volume<float>& volume, const std::optional<Beam>& beam,
                 const Progress& progress) {
  write(path, volume, beam, progress);
}

void writeVolume(const fs::path& path, const Volume<std::uint8_t>& volume, const std::optional<Beam>& beam,
                 const Progress& progress) {
  write(path, volume, beam, progress);
}

void writeScan(const fs::path& path, const Scan& scan, const Progress& progress) {
  require(scan.volume != nullptr, "There is no volume to write to {}; open one first.", path.string());
  if (scan.originalType != "uint8") return writeVolume(path, *scan.volume, scan.beam, progress);
  Volume<std::uint8_t> bytes(scan.volume->geometry);
  std::transform(scan.volume->data.begin(), scan.volume->data.end(), bytes.data.begin(),
                 [](float v) { return std::uint8_t(std::lround(255 * std::clamp(v, 0.f, 1.f))); });
  writeVolume(path, bytes, scan.beam, progress);
}

}  // namespace sonoskin
