#include "render/light_volume.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

Geometry coarseGeometry(const Geometry& fine, int coarse) {
  Geometry g = fine;
  // At least two cells along each axis, so that the result can be sampled.
  g.dims = glm::max((fine.dims + coarse - 1) / coarse, glm::ivec3(2));
  g.spacing = fine.spacing * double(coarse);
  g.origin = fine.toWorld(glm::dvec3(0.5 * (coarse - 1)));
  return g;
}

std::array<float, 256> extinctionTable(const TransferFunction& transfer, double diagonal) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = extinctionPerMm(transfer.at(float(i) / 255.0f).a, diagonal);
  return table;
}

// The mean extinction of the voxels of one cell, 1/mm.
float cellExtinction(const Volume<float>& volume, const std::array<float, 256>& table,
                     const glm::ivec3& first, int coarse) {
  const glm::ivec3 end = glm::min(first + coarse, volume.geometry.dims);
  float sum = 0;
  int count = 0;
  for (int k = first.z; k < end.z; ++k)
    for (int j = first.y; j < end.y; ++j)
      for (int i = first.x; i < end.x; ++i, ++count)
        sum += table[std::size_t(255 * std::clamp(volume.at(i, j, k), 0.0f, 1.0f))];
  return count ? sum / float(count) : 0;
}

float transmittance(const Volume<float>& extinction, glm::vec3 index, const glm::vec3& step, float stepMm) {
  const glm::vec3 last(extinction.geometry.dims - 1);
  float depth = 0;
  // The first half step would be the place's own cell: start beyond it.
  for (index += step; glm::all(glm::greaterThanEqual(index, glm::vec3(0))) &&
                      glm::all(glm::lessThanEqual(index, last)) && depth < 8;
       index += step)
    depth += stepMm * sampleTrilinear(extinction, index);
  return std::exp(-depth);
}

}  // namespace

float extinctionPerMm(float opacity, double diagonal) {
  return float(-std::log1p(-std::min(double(opacity), 0.999)) * 250 / diagonal);
}

double worldDiagonal(const Geometry& geometry) {
  return glm::length(geometry.spacing * glm::dvec3(geometry.dims - 1));
}

Volume<float> lightVolume(const Volume<float>& volume, const TransferFunction& transfer,
                          const glm::vec3& toLight, int coarse) {
  Volume<float> extinction(coarseGeometry(volume.geometry, coarse));
  const Geometry& g = extinction.geometry;
  const auto table = extinctionTable(transfer, worldDiagonal(volume.geometry));
  parallelFor(g.dims.z, [&](std::ptrdiff_t k) {
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        extinction.at(i, j, int(k)) = cellExtinction(volume, table, coarse * glm::ivec3(i, j, k), coarse);
  });
  Volume<float> light(g);
  const double stepMm = g.minSpacing();
  const glm::vec3 step(stepMm * (glm::transpose(g.direction) * glm::dvec3(toLight)) / g.spacing);
  parallelFor(g.dims.z, [&](std::ptrdiff_t k) {
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        light.at(i, j, int(k)) = transmittance(extinction, glm::vec3(i, j, k), step, float(stepMm));
  });
  return light;
}

}  // namespace sonoskin
