#include "core/volume/scan_convert.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/convert_pyramid.h"
#include "core/volume/convert_swept.h"

namespace sonoskin {
namespace {

struct Extent {
  glm::dvec3 low, high;
};

constexpr int kMostAlongAxis = 65535;

double nearestToZero(const std::vector<double>& table) {
  const double low = std::min(table.front(), table.back()), high = std::max(table.front(), table.back());
  return std::clamp(0.0, low, high);
}

// Of all samples: places are monotonic in each of their coordinates but for the angles' cosines, which are largest at 0.
Extent boxOf(const SweptGrid& g) {
  const double first = g.firstRadius, last = g.lastRadius();
  const auto [t0, t1] = std::minmax(g.fan.front(), g.fan.back());
  const auto [p0, p1] = std::minmax(g.sweep.front(), g.sweep.back());
  const double widest = std::max(std::abs(t0), std::abs(t1)), steepest = std::max(std::abs(p0), std::abs(p1));
  const double near = (g.parallel ? first : first * std::cos(widest)) - g.axisDepth;
  const double far = (g.parallel ? last : last * std::cos(nearestToZero(g.fan))) - g.axisDepth;
  const auto across = [&](double t) {
    if (g.parallel) return std::pair(t, t);
    const double a = first * std::sin(t), b = last * std::sin(t);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const auto aside = [&](double p) {
    const double a = -near * std::sin(p), b = -far * std::sin(p);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  return {{across(t0).first, aside(p1).first, g.axisDepth + near * std::cos(steepest)},
          {across(t1).second, aside(p0).second, g.axisDepth + far * std::cos(nearestToZero(g.sweep))}};
}

// The cube root of what a sample takes up in the middle of the depth.
double edgeOf(const SweptGrid& g) {
  const double radius = 0.5 * (g.firstRadius + g.lastRadius());
  const double beams = std::abs(g.fan.back() - g.fan.front()) / double(g.fan.size() - 1);
  const double pictures = std::abs(g.sweep.back() - g.sweep.front()) / double(g.sweep.size() - 1);
  return std::cbrt(g.sampleDistance * (g.parallel ? beams : beams * radius) * pictures *
                   (radius - g.axisDepth));
}

Geometry cubesIn(const Extent& box, double edge) {
  Geometry g;
  const glm::dvec3 extent = box.high - box.low;
  const glm::dvec3 steps = glm::min(glm::ceil(extent / edge - 1e-9), glm::dvec3(1e9));  // as an int bears
  g.dims = glm::max(glm::ivec3(steps) + 1, glm::ivec3(2));
  g.spacing = glm::dvec3(edge);
  g.origin = 0.5 * (box.low + box.high) - 0.5 * edge * glm::dvec3(g.dims - 1);
  return g;
}

// A chosen edge grows until there are no more voxels than mostVoxels, nor along an axis than a volume can have.
Geometry cubesWithin(const Extent& box, double edge, double mostVoxels) {
  const double most = std::max(mostVoxels, 1000.0);
  const auto tooMany = [&](double e) {
    const glm::dvec3 n = (box.high - box.low) / e + 2.0;
    return n.x * n.y * n.z > most || glm::any(glm::greaterThan(n, glm::dvec3(kMostAlongAxis)));
  };
  while (tooMany(edge)) edge *= 1.1;
  return cubesIn(box, edge);
}

double hundredths(double mm) { return std::max(0.01, std::round(100 * mm) / 100); }

Extent boxOf(const PyramidGrid& g) {
  const double first = g.middle() - 0.5 * g.lastWidth();
  return {{0, 0, first}, {(g.dims.x - 1) * g.lateral, (g.dims.y - 1) * g.depth, first + g.lastWidth()}};
}

Geometry ownVoxels(const PyramidGrid& g) {
  Geometry own;
  own.dims = {g.dims.x, g.dims.y, int(std::lround(g.lastWidth() / g.elevationStep()))};
  own.spacing = {g.lateral, g.depth, g.elevationStep()};
  return own;
}

}  // namespace

Geometry voxelsOf(const SampleGrid& grid, double edge, double mostVoxels) {
  const Extent box = std::visit([](const auto& g) { return boxOf(g); }, grid);
  if (edge > 0) return cubesIn(box, edge);
  if (const auto* swept = std::get_if<SweptGrid>(&grid))
    return cubesWithin(box, hundredths(edgeOf(*swept)), mostVoxels);
  const auto& pyramid = std::get<PyramidGrid>(grid);
  const Geometry own = ownVoxels(pyramid);
  return double(own.voxels()) <= mostVoxels && own.dims.z <= kMostAlongAxis
             ? own
             : cubesWithin(box, pyramid.lateral, mostVoxels);
}

ConvertedScan convertScan(const SampleGrid& grid, const Volume<float>& samples, const Geometry& geometry,
                          const Progress& progress) {
  ConvertedScan converted{Volume<float>::unset(geometry), Volume<std::uint8_t>::unset(geometry)};
  const auto fill = [&](const auto& converter) {
    parallelFor(
        geometry.dims.z, [&](std::ptrdiff_t k) { converter.fillSlice(int(k), converted); }, progress);
  };
  if (const auto* swept = std::get_if<SweptGrid>(&grid))
    fill(SweptConverter(*swept, samples.data, geometry));
  else
    fill(PyramidConverter(std::get<PyramidGrid>(grid), samples.data, geometry));
  return converted;
}

}  // namespace sonoskin
