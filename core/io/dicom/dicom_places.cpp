#include "core/io/dicom/dicom_places.h"

#include <algorithm>
#include <cmath>

#include "core/io/dicom/dicom_straighten.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr double kSamePlace = 0.005;  // mm
constexpr double kOffPlace = 0.1;     // of the distance of slices, or of pixels

std::vector<double> gapsOf(const std::vector<DicomPlace>& places) {
  std::vector<double> gaps;
  for (std::size_t s = 1; s < places.size(); ++s) gaps.push_back(places[s].along - places[s - 1].along);
  return gaps;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Why places are not evenly spaced: some of an even series are missing, or it is none.
Error unevenness(const std::vector<DicomPlace>& places, const fs::path& path) {
  const std::vector<double> gaps = gapsOf(places);
  const double usual = median(gaps);
  double missing = 0;
  std::size_t first = gaps.size();
  bool whole = true;
  for (std::size_t g = 0; g < gaps.size(); ++g) {
    const double steps = std::round(gaps[g] / usual);
    whole = whole && steps >= 1 && std::abs(gaps[g] - steps * usual) <= kOffPlace * usual;
    if (steps > 1) first = std::min(first, g);
    missing += steps - 1;
  }
  if (whole && missing > 0 && missing < 1e6)
    return Error(
        fmt::format("Of the slices of the series in {} {:.0f} {} missing, the first one after slice {} of "
                    "{}; get a complete copy.",
                    path.string(), missing, missing > 1 ? "are" : "is", first + 1, places.size()));
  const auto [least, most] = std::ranges::minmax(gaps);
  return Error(
      fmt::format("The slices of the series in {} are not evenly spaced: {:.4g} to {:.4g} mm apart; "
                  "resample them to even distances first.",
                  path.string(), least, most));
}

// Whether places are those of an even row, but for as much as a header's decimals may make of them.
bool isEven(const std::vector<DicomPlace>& places) {
  const double step = (places.back().along - places.front().along) / double(places.size() - 1);
  double least = 0, most = 0;
  for (std::size_t s = 0; s < places.size(); ++s) {
    const double off = places[s].along - places.front().along - double(s) * step;
    least = std::min(least, off), most = std::max(most, off);
  }
  return (most - least) / 2 <= kOffPlace * step;
}

// How far each slice lies across the one before; nothing where that is not the same for all.
std::optional<glm::dvec2> shiftOf(const std::vector<DicomPlace>& places) {
  const DicomFrame& first = *places.front().frames.front();
  const auto across = [&](const DicomPlace& place) {
    const glm::dvec3 from = *place.frames.front()->position - *first.position;
    return glm::dvec2(glm::dot(from, first.row), glm::dot(from, first.column));
  };
  const glm::dvec2 shift = across(places.back()) / double(places.size() - 1);
  for (std::size_t s = 0; s < places.size(); ++s) {
    const glm::dvec2 off = glm::abs(across(places[s]) - double(s) * shift);
    if (off.x > kOffPlace * first.spacing.x || off.y > kOffPlace * first.spacing.y) return {};
  }
  // Less than the decimals of the directions can say, or than can be seen, is none.
  const glm::dvec2 all = glm::abs(shift) * double(places.size() - 1);
  const double length = places.back().along - places.front().along;
  const bool straight = all.x <= std::max(kOffPlace * first.spacing.x, 2e-4 * length) &&
                        all.y <= std::max(kOffPlace * first.spacing.y, 2e-4 * length);
  return straight ? glm::dvec2(0) : shift;
}

// Whether a straight grid is not much larger than what it holds.
bool isWorthIt(const Geometry& g, const glm::dvec2& shift) {
  constexpr double kSmall = 1 << 22, kMostGrowth = 4;  // voxels
  const glm::dvec3 grid(straightened(g, shift)), dims(g.dims);
  const double voxels = grid.x * grid.y * grid.z;
  return voxels <= kSmall || voxels <= kMostGrowth * dims.x * dims.y * dims.z;
}

void compareSpacing(DicomVolume& volume, const DicomFrame& first) {
  const double told = first.slices, found = volume.geometry.spacing.z;
  if (told > 0 && std::abs(told - found) > 0.01 * found)
    volume.warnings.push_back(
        fmt::format("The slices are {:.4g} mm apart by their places, which are used, and {:.4g} mm "
                    "by what the file says of their distance.",
                    found, told));
}

}  // namespace

std::vector<DicomPlace> placesOf(const std::vector<DicomFrame>& frames) {
  std::vector<DicomPlace> all;
  if (frames.empty()) return all;
  const glm::dvec3 normal = frames.front().normal();
  for (const DicomFrame& frame : frames) all.push_back({glm::dot(*frame.position, normal), {&frame}});
  std::ranges::stable_sort(all, {}, &DicomPlace::along);
  std::vector<DicomPlace> places;
  for (const DicomPlace& one : all)
    if (!places.empty() && one.along - places.back().along <= kSamePlace)
      places.back().frames.push_back(one.frames.front());
    else
      places.push_back(one);
  return places;
}

void setPlaces(DicomVolume& volume, const std::vector<DicomPlace>& places, const fs::path& path) {
  const DicomFrame& first = *places.front().frames.front();
  Geometry& g = volume.geometry;
  const double step = (places.back().along - places.front().along) / double(places.size() - 1);
  g.spacing = {first.spacing, step};
  g.origin = *first.position;
  g.direction = {first.row, first.column, first.normal()};
  volume.spacingKnown = first.spacingKnown;
  if (!isEven(places)) {
    volume.refusal = unevenness(places, path);
    return;
  }
  const auto shift = shiftOf(places);
  if (!shift)
    volume.refusal =
        Error(fmt::format("The slices of the series in {} are shifted against each other, and not evenly; "
                          "resample them to a straight grid first.",
                          path.string()));
  volume.shift = shift.value_or(glm::dvec2(0));
  if (!isWorthIt(g, volume.shift))
    volume.refusal = Error(fmt::format(
        "Each slice of the series in {} lies {:.4g} mm across the one before, too far for a straight grid; "
        "resample them first.",
        path.string(), glm::length(volume.shift)));
  compareSpacing(volume, first);
}

}  // namespace sonoskin
