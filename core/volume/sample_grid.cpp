#include "core/volume/sample_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace sonoskin {
namespace {

constexpr int kMostSamples = 65535;
constexpr double kMostVoxels = 2147483648.0;
constexpr double kMostLength = 10'000;                   // mm
constexpr double kMostAngle = 0.48 * glm::pi<double>();  // rad from the middle: short of where places fold
constexpr double kLeastWidth = 1e-3;                     // of a fan or sweep, rad or mm
constexpr double kLeastDistance = 1e-4;                  // mm from sample to sample

bool isStrictlyMonotonic(const std::vector<double>& table) {
  if (table.size() < 2 || !std::all_of(table.begin(), table.end(), [](double v) { return std::isfinite(v); }))
    return false;
  const bool rises = table[0] < table[1];
  return std::adjacent_find(table.begin(), table.end(),
                            [&](double a, double b) { return rises ? !(a < b) : !(a > b); }) == table.end();
}

double widthOf(const std::vector<double>& table) { return std::abs(table.back() - table.front()); }

double largest(const std::vector<double>& table) {  // in size; the ends of a monotonic table tell
  return std::max(std::abs(table.front()), std::abs(table.back()));
}

std::optional<std::string> sizeFault(const glm::ivec3& dims) {
  for (int a = 0; a < 3; ++a)
    if (dims[a] < 2 || dims[a] > kMostSamples)
      return fmt::format("it has {} samples along one axis, and 2 to {} are possible", dims[a], kMostSamples);
  if (double(dims.x) * double(dims.y) * double(dims.z) > kMostVoxels)
    return fmt::format("it has {} x {} x {} samples, more than fit into memory", dims.x, dims.y, dims.z);
  return {};
}

std::optional<std::string> faultOf(const SweptGrid& g) {
  if (!isStrictlyMonotonic(g.fan) || !isStrictlyMonotonic(g.sweep))
    return "the angles of its beams do not rise or fall from one to the next";
  if (widthOf(g.fan) < kLeastWidth || widthOf(g.sweep) < kLeastWidth) return "its beams all run the same way";
  if (largest(g.sweep) > kMostAngle || (!g.parallel && largest(g.fan) > kMostAngle))
    return "the angles of its beams are wider than half a turn";
  if (!(g.sampleDistance >= kLeastDistance) || !std::isfinite(g.firstRadius) || !std::isfinite(g.axisDepth) ||
      !(g.lastRadius() <= kMostLength) || !(std::abs(g.axisDepth) <= kMostLength) ||
      (g.parallel && largest(g.fan) > kMostLength))
    return "its lengths are those of no probe";
  const double leastDepth = g.firstRadius * (g.parallel ? 1.0 : std::cos(largest(g.fan)));
  if (!(leastDepth >= g.axisDepth) || (!g.parallel && !(g.firstRadius >= 0)))
    return "its beams begin before the axis that they are turned about";
  return {};
}

std::optional<std::string> faultOf(const PyramidGrid& g) {
  const auto isLength = [](double mm) { return mm >= kLeastDistance && mm <= kMostLength; };
  if (!isLength(g.lateral) || !isLength(g.depth) || !(g.aperture >= 0 && g.aperture <= kMostLength) ||
      !(g.growth >= 0 && g.growth <= 2 * std::tan(kMostAngle)) || !isLength(g.lastWidth()) ||
      !isLength(g.dims.x * g.lateral) || !isLength(g.dims.y * g.depth))
    return "its lengths are those of no probe";
  return {};
}

glm::dvec3 placeOf(const SweptGrid& g, const glm::dvec3& index) {
  const auto at = [](const std::vector<double>& table, double entry) {
    const auto low = std::size_t(std::clamp(entry, 0.0, double(table.size() - 2)));
    return table[low] + (entry - double(low)) * (table[low + 1] - table[low]);
  };
  const double r = g.firstRadius + index.x * g.sampleDistance;
  const double t = at(g.fan, index.y), p = at(g.sweep, index.z);
  const double fromAxis = (g.parallel ? r : r * std::cos(t)) - g.axisDepth;
  return {g.parallel ? t : r * std::sin(t), -fromAxis * std::sin(p), g.axisDepth + fromAxis * std::cos(p)};
}

glm::dvec3 placeOf(const PyramidGrid& g, const glm::dvec3& index) {
  const double y = index.y * g.depth;
  return {index.x * g.lateral, y, g.middle() + ((index.z + 0.5) / g.dims.z - 0.5) * g.widthAt(y)};
}

std::optional<glm::dvec3> indexOf(const SweptGrid& g, const glm::dvec3& place) {
  const double behind = place.z - g.axisDepth;
  if (!(behind > 0)) return {};
  const double d = std::hypot(place.y, behind) + g.axisDepth;
  const auto k = tableIndex(g.sweep, std::atan2(-place.y, behind));
  const auto j = tableIndex(g.fan, g.parallel ? place.x : std::atan2(place.x, d));
  const double r = g.parallel ? d : std::hypot(place.x, d);
  const double i = (r - g.firstRadius) / g.sampleDistance;
  if (!j || !k || !(i >= 0 && i <= g.samples - 1)) return {};
  return glm::dvec3(i, *j, *k);
}

// Beyond the middle of the outermost cells their samples hold.
std::optional<glm::dvec3> indexOf(const PyramidGrid& g, const glm::dvec3& place) {
  const double width = g.widthAt(place.y);
  const glm::dvec3 cell(place.x / g.lateral + 0.5, place.y / g.depth + 0.5,
                        g.dims.z * (0.5 + (place.z - g.middle()) / width));
  if (!(width > 0) || !glm::all(glm::greaterThanEqual(cell, glm::dvec3(0))) ||
      !glm::all(glm::lessThanEqual(cell, glm::dvec3(g.dims))))
    return {};
  return glm::clamp(cell - 0.5, glm::dvec3(0), glm::dvec3(g.dims - 1));
}

}  // namespace

double PyramidGrid::elevationStep() const {
  const double plane = lastWidth() / dims.z;
  constexpr double kMostBetween = 16;  // voxels between two pictures; more would show nothing more
  return plane / std::clamp(std::round(plane / lateral), 1.0, kMostBetween);
}

glm::ivec3 gridDims(const SampleGrid& grid) {
  if (const auto* swept = std::get_if<SweptGrid>(&grid)) {
    // A table that is too long is no int's matter: gridFault refuses what is clamped here.
    const auto count = [](const std::vector<double>& table) {
      return int(std::min<std::size_t>(table.size(), kMostSamples + 1));
    };
    return {swept->samples, count(swept->fan), count(swept->sweep)};
  }
  return std::get<PyramidGrid>(grid).dims;
}

std::string gridName(const SampleGrid& grid) {
  const auto* swept = std::get_if<SweptGrid>(&grid);
  if (!swept) return "pyramid of pictures";
  return swept->parallel ? "swept picture of parallel beams" : "swept fan of beams";
}

std::optional<std::string> gridFault(const SampleGrid& grid) {
  if (auto fault = sizeFault(gridDims(grid))) return fault;
  return std::visit([](const auto& g) { return faultOf(g); }, grid);
}

glm::dvec3 gridPlace(const SampleGrid& grid, const glm::dvec3& index) {
  return std::visit([&](const auto& g) { return placeOf(g, index); }, grid);
}

std::optional<glm::dvec3> gridIndex(const SampleGrid& grid, const glm::dvec3& place) {
  return std::visit([&](const auto& g) { return indexOf(g, place); }, grid);
}

std::optional<Beam> gridBeam(const SampleGrid& grid) {
  const auto* swept = std::get_if<SweptGrid>(&grid);
  if (!swept) return {};
  Beam beam;
  beam.axis = {0, 0, 1};
  beam.apex = swept->parallel ? glm::dvec3(0, 0, swept->axisDepth) : glm::dvec3(0);
  return beam;
}

std::optional<double> tableIndex(const std::vector<double>& table, double value) {
  const bool rises = table.front() < table.back();
  const auto before = [&](double a, double b) { return rises ? a < b : a > b; };
  if (!(rises ? value >= table.front() && value <= table.back()
              : value <= table.front() && value >= table.back()))
    return {};
  const auto above = std::upper_bound(table.begin(), table.end() - 1, value, before);
  const auto low = std::size_t(std::max<std::ptrdiff_t>(above - table.begin() - 1, 0));
  return double(low) + (value - table[low]) / (table[low + 1] - table[low]);
}

}  // namespace sonoskin
