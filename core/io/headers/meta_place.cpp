#include "core/io/headers/meta_place.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/headers/units.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Numbers = std::vector<double>;

// The numbers of the first of some keys that mean the same; none where none is there.
Numbers numbersOf(const MetaFields& meta, std::initializer_list<const char*> keys, std::size_t count,
                  const char* what, const fs::path& path) {
  Numbers found;
  for (const char* key : keys) {
    if (!meta.has(key)) continue;
    const auto numbers = parseNumbers<double>(meta[key]);
    require(numbers && numbers->size() == count &&
                std::all_of(numbers->begin(), numbers->end(), [](double v) { return std::isfinite(v); }),
            "The {} in {} is not {} finite numbers; correct the header.", what, path.string(), count);
    require(found.empty() || found == *numbers,
            "{} gives its {} twice, and not the same; correct the header.", path.string(), what);
    found = *numbers;
  }
  return found;
}

void placeDirections(const Numbers& matrix, std::size_t axes, DeclaredData& data) {
  if (matrix.empty()) return;
  for (int a = 0; a < 3; ++a) {
    const std::size_t row = std::size_t(data.spaceAxes[std::size_t(a)]) * axes;
    for (int r = 0; r < 3; ++r) data.stored.geometry.direction[a][r] = matrix[row + std::size_t(r)] + 0.0;
  }
}

// [MetaIO, AnatomicalOrientation]: the side of the body on which each axis begins.
char sideOf(const glm::dvec3& axis) {
  int most = 0;
  for (int r = 1; r < 3; ++r)
    if (std::abs(axis[r]) > std::abs(axis[most])) most = r;
  return (axis[most] >= 0 ? "RAI" : "LPS")[most];
}

void checkOrientation(const MetaFields& meta, const DeclaredData& data, const fs::path& path) {
  const std::string_view letters = meta["AnatomicalOrientation"];
  require(letters.size() <= std::max<std::size_t>(data.sizes.size(), 3),
          "The orientation in {} is not one letter per axis; correct the header.", path.string());
  for (std::size_t a = 0; a < std::min<std::size_t>(letters.size(), 3); ++a) {
    if (letters[a] == '?' || letters[a] == sideOf(data.stored.geometry.direction[int(a)])) continue;
    log(LogLevel::warning,
        "The header's AnatomicalOrientation contradicts its TransformMatrix; the matrix holds, or the axes "
        "as they "
        "are where there is none.");
    return;
  }
}

// DICOM's word for the machine.
std::string modalityOf(std::string_view name) {
  return name == "MET_MOD_US" ? "US" : name == "MET_MOD_CT" ? "CT" : name == "MET_MOD_MR" ? "MR" : "";
}

}  // namespace

void placeMeta(const MetaFields& meta, DeclaredData& data, const fs::path& path) {
  const std::size_t axes = data.sizes.size();
  const Numbers spacing = numbersOf(meta, {"ElementSpacing"}, axes, "spacing", path),
                size = numbersOf(meta, {"ElementSize"}, axes, "spacing", path),
                origin = numbersOf(meta, {"Offset", "Position", "Origin"}, axes, "origin", path),
                matrix = numbersOf(meta, {"TransformMatrix", "Rotation", "Orientation"}, axes * axes,
                                   "direction of the axes", path);
  const Numbers& steps =
      spacing.empty() ? size : spacing;  // size: of the region that was measured around a voxel
  const double unit = millimetresOrWarn(meta["DistanceUnits"]);
  Geometry& g = data.stored.geometry;
  data.stored.spacingKnown = !steps.empty();
  for (int a = 0; a < 3; ++a) {
    const std::size_t n = std::size_t(data.spaceAxes[std::size_t(a)]);
    if (!steps.empty()) g.spacing[a] = steps[n] * unit;
    if (!origin.empty()) g.origin[a] = origin[std::size_t(a)] * unit;
  }
  placeDirections(matrix, axes, data);
  if (!data.poses) checkOrientation(meta, data, path);
  data.stored.modality = modalityOf(meta["Modality"]);
}

}  // namespace sonoskin
