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

std::size_t byteOf(float value) { return std::size_t(255 * std::clamp(value, 0.0f, 1.0f)); }
std::size_t byteOf(std::uint8_t value) { return value; }

// The mean extinction of the voxels of one cell, 1/mm.
template <class T>
float cellExtinction(const Volume<T>& volume, const std::array<float, 256>& table, const glm::ivec3& first,
                     int coarse) {
  const glm::ivec3 end = glm::min(first + coarse, volume.geometry.dims);
  float sum = 0;
  int count = 0;
  for (int k = first.z; k < end.z; ++k)
    for (int j = first.y; j < end.y; ++j)
      for (int i = first.x; i < end.x; ++i, ++count) sum += table[byteOf(volume.at(i, j, k))];
  return count ? sum / float(count) : 0;
}

// What light has passed when it comes to the cells of one plane across an axis: that of the next plane toward it, where it
// came through, and that plane's own extinction. Interpolated; nothing lies outside.
struct PlaneSweep {
  const Volume<float>& extinction;
  Volume<float>& depth;
  int axis;
  glm::vec3 step;  // cells; a whole one along the axis
  float stepMm;

  float passedAt(const glm::ivec3& cell) const {
    const glm::ivec3 last = depth.geometry.dims - 1;
    const glm::vec3 place = glm::vec3(cell) + step;
    if (glm::any(glm::lessThan(place, glm::vec3(0))) || glm::any(glm::greaterThan(place, glm::vec3(last))))
      return 0;
    return sampleTrilinear(depth, place) + stepMm * sampleTrilinear(extinction, place);
  }
  void fill(int plane) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const glm::ivec3 dims = depth.geometry.dims;
    parallelFor(dims[v], [&](std::ptrdiff_t row) {
      glm::ivec3 cell;
      cell[axis] = plane;
      cell[v] = int(row);
      for (cell[u] = 0; cell[u] < dims[u]; ++cell[u]) depth.at(cell.x, cell.y, cell.z) = passedAt(cell);
    });
  }
};

// The optical depth from each cell's border toward the light, plane by plane from where the light comes in.
Volume<float> opticalDepth(const Volume<float>& extinction, const glm::vec3& toLight) {
  const Geometry& g = extinction.geometry;
  glm::vec3 step(glm::transpose(g.direction) * glm::dvec3(toLight) / g.spacing);
  const glm::vec3 size = glm::abs(step);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  step /= size[axis];
  step[axis] = step[axis] > 0 ? 1.0f : -1.0f;
  Volume<float> depth(g);
  PlaneSweep sweep{extinction, depth, axis, step, float(glm::length(glm::dvec3(step) * g.spacing))};
  const int count = g.dims[axis];
  for (int n = 1; n < count; ++n) sweep.fill(step[axis] > 0 ? count - 1 - n : n);
  return depth;
}

template <class T>
Volume<float> extinctionOf(const Volume<T>& volume, const TransferFunction& transfer, int coarse,
                           const ShownPart& part) {
  Volume<float> extinction(coarseGeometry(volume.geometry, coarse));
  const Geometry& g = extinction.geometry;
  const auto table = extinctionTable(transfer, worldDiagonal(volume.geometry));
  parallelFor(g.dims.z, [&](std::ptrdiff_t k) {
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const glm::ivec3 cell(i, j, k);
        if (part.holds(glm::vec3(coarse * cell) + 0.5f * float(coarse - 1), volume.geometry))
          extinction.at(i, j, int(k)) = cellExtinction(volume, table, coarse * cell, coarse);
      }
  });
  return extinction;
}

}  // namespace

float extinctionPerMm(float opacity, double diagonal) {
  return float(-std::log1p(-std::min(double(opacity), 0.999)) * 250 / diagonal);
}

bool ShownPart::holds(const glm::vec3& index, const Geometry& geometry) const {
  const glm::vec3 share = index / glm::max(glm::vec3(geometry.dims - 1), glm::vec3(1));
  return glm::all(glm::greaterThanEqual(share, cropMin)) && glm::all(glm::lessThanEqual(share, cropMax)) &&
         clip.keeps(glm::vec3(geometry.toWorld(glm::dvec3(index))));
}

double worldDiagonal(const Geometry& geometry) {
  return glm::length(geometry.spacing * glm::dvec3(geometry.dims - 1));
}

Volume<float> extinctionVolume(const Volume<float>& volume, const TransferFunction& transfer, int coarse,
                               const ShownPart& part) {
  return extinctionOf(volume, transfer, coarse, part);
}

Volume<float> extinctionVolume(const Volume<std::uint8_t>& volume, const TransferFunction& transfer,
                               int coarse, const ShownPart& part) {
  return extinctionOf(volume, transfer, coarse, part);
}

Volume<float> lightVolume(const Volume<float>& extinction, const glm::vec3& toLight) {
  Volume<float> light = opticalDepth(extinction, toLight);
  for (float& value : light.data) value = std::exp(-value);
  return light;
}

}  // namespace sonoskin
