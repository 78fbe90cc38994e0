#include "core/volume/convert_pyramid.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {

PyramidConverter::PyramidConverter(const PyramidGrid& grid, const LargeArray<float>& samples,
                                   const Geometry& geometry)
    : grid_(grid), samples_(samples.data()), geometry_(geometry), across_(std::size_t(geometry.dims.x)) {
  for (int i = 0; i < geometry.dims.x; ++i)
    across_[std::size_t(i)] = placeIn(geometry.toWorld({i, 0, 0}).x / grid.lateral + 0.5, grid.dims.x);
}

// Beyond the middle of the outermost cells their samples hold.
PyramidConverter::Place PyramidConverter::placeIn(double cell, int cells) {
  if (!(cell >= 0 && cell <= cells)) return {};
  const double at = std::clamp(cell - 0.5, 0.0, double(cells - 1));
  const int low = std::min(int(at), cells - 2);
  return {low, float(at - low), true};
}

void PyramidConverter::fillSlice(int k, ConvertedScan& converted) const {
  std::vector<float> mixed(std::size_t(grid_.dims.x));
  for (int j = 0; j < geometry_.dims.y; ++j) {
    float* values = &converted.volume.at(0, j, k);
    std::uint8_t* scanned = &converted.scanned.at(0, j, k);
    const glm::dvec3 start = geometry_.toWorld({0, j, k});
    const double width = grid_.widthAt(start.y);
    const Place row = placeIn(start.y / grid_.depth + 0.5, grid_.dims.y);
    const Place picture =
        width > 0 ? placeIn(grid_.dims.z * (0.5 + (start.z - grid_.middle()) / width), grid_.dims.z)
                  : Place{};
    const bool sampled = row.sampled && picture.sampled;
    if (sampled) mixRow(row, picture, mixed);
    for (int i = 0; i < geometry_.dims.x; ++i) {
      const Place& across = across_[std::size_t(i)];
      scanned[i] = sampled && across.sampled;
      const float* pair = mixed.data() + across.low;
      values[i] = scanned[i] ? pair[0] + across.part * (pair[1] - pair[0]) : 0;
    }
  }
}

void PyramidConverter::mixRow(const Place& row, const Place& picture, std::vector<float>& mixed) const {
  const std::ptrdiff_t width = grid_.dims.x, plane = width * grid_.dims.y;
  const float* near = samples_ + picture.low * plane + row.low * width;
  const float* far = near + plane;
  for (std::ptrdiff_t i = 0; i < width; ++i) {
    const float low = near[i] + row.part * (near[i + width] - near[i]);
    const float high = far[i] + row.part * (far[i + width] - far[i]);
    mixed[std::size_t(i)] = low + picture.part * (high - low);
  }
}

}  // namespace sonoskin
