#include "core/io/headers/tracked_pictures.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/headers/number_types.h"
#include "core/io/headers/pose_chain.h"
#include "core/io/headers/voxel_numbers.h"
#include "core/volume/sweep.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// The pictures that have a place, their grey only.
template <class T>
struct Placed {
  std::vector<T> pixels;
  std::vector<glm::dmat4> poses;
};

// Rec. 709, as core/io/normalise.cpp has it.
constexpr double kLuminance[3] = {0.2126, 0.7152, 0.0722};

template <class T>
Placed<T> placedPictures(const DeclaredData& data, const std::vector<std::uint8_t>& numbers,
                         const std::vector<std::optional<glm::dmat4>>& poses) {
  const glm::ivec3& dims = data.stored.geometry.dims;
  const std::size_t each = std::size_t(dims.x) * std::size_t(dims.y),
                    colours = std::size_t(data.stored.components);
  Placed<T> placed;
  visitNumber(data.stored.type, [&](auto number) {
    const auto at = [&](std::size_t n) {
      std::memcpy(&number, numbers.data() + n * sizeof number, sizeof number);
      return double(number);
    };
    for (std::size_t f = 0; f < poses.size(); ++f) {
      if (!poses[f]) continue;
      placed.poses.push_back(*poses[f]);
      for (std::size_t p = f * each; p < (f + 1) * each; ++p) {
        double grey = at(p * colours);
        if (colours >= 3)
          grey = kLuminance[0] * grey + kLuminance[1] * at(p * colours + 1) +
                 kLuminance[2] * at(p * colours + 2);
        placed.pixels.push_back(std::is_integral_v<T> ? T(std::lround(grey)) : T(grey));
      }
    }
  });
  return placed;
}

void notePictures(std::size_t placed, std::size_t all) {
  log(LogLevel::info, fmt::format("A sweep of {} tracked pictures was reconstructed to a volume.", placed));
  if (placed < all)
    log(LogLevel::warning,
        fmt::format("{} of {} pictures have no valid place and were left out.", all - placed, all));
}

// Down the pictures, whichever of their axes that is.
Beam beamOf(const Geometry& g, const glm::dmat4& oriented) {
  Beam beam{{}, glm::dvec3(0), glm::dvec3(0)};
  for (int a = 0; a < 2; ++a) {
    beam.up += oriented[a][0] * g.direction[a];
    beam.axis += oriented[a][1] * g.direction[a];
  }
  return beam;
}

template <class T>
LoadedVolume reconstruct(const DeclaredData& data, const std::vector<std::uint8_t>& numbers,
                         const std::vector<std::optional<glm::dmat4>>& poses, const Progress& progress) {
  const glm::ivec3& dims = data.stored.geometry.dims;
  const Placed<T> placed = placedPictures<T>(data, numbers, poses);
  notePictures(placed.poses.size(), poses.size());
  const SweptVolume swept =
      reconstructSweep(SweepFrames<T>{dims.x, dims.y, placed.pixels, placed.poses}, progress);
  LoadedVolume loaded;
  loaded.stored.geometry = swept.volume.geometry;
  loaded.stored.type = std::is_integral_v<T> ? NumberType::uint8 : NumberType::float32;
  loaded.stored.modality = "US";
  loaded.mask.assign(swept.mask.data.begin(), swept.mask.data.end());
  loaded.numbers.resize(swept.volume.data.size() * sizeof(T));
  for (std::size_t v = 0; v < swept.volume.data.size(); ++v) {
    const float value = swept.volume.data[v];
    const T number = std::is_integral_v<T> ? T(std::lround(value)) : T(value);
    std::memcpy(loaded.numbers.data() + v * sizeof(T), &number, sizeof(T));
  }
  return loaded;
}

}  // namespace

LoadedVolume reconstructPictures(const DeclaredData& data, const fs::path& path, const Progress& progress) {
  const glm::ivec3& dims = data.stored.geometry.dims;
  numbersIn(data, path);  // sizes are in range
  require(dims.x >= 2 && dims.y >= 2, "{} has pictures of {} x {} pixels; choose a volume.", path.string(),
          dims.x, dims.y);
  auto poses = picturePoses(*data.poses, std::size_t(dims.z), path);
  const glm::dmat4 oriented = orientedPixels(data.poses->orientation, dims.x, dims.y, path);
  for (auto& pose : poses)
    if (pose) *pose = *pose * oriented;
  const std::vector<std::uint8_t> numbers = readNumbers(data, path, 0, progress.part(0, 0.4));
  LoadedVolume loaded = data.stored.type == NumberType::uint8
                            ? reconstruct<std::uint8_t>(data, numbers, poses, progress.part(0.4, 1))
                            : reconstruct<float>(data, numbers, poses, progress.part(0.4, 1));
  loaded.stored.beam = beamOf(loaded.stored.geometry, oriented);
  checkGeometry(loaded.stored, path);
  return loaded;
}

}  // namespace sonoskin
