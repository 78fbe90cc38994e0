#include "render/plane_slices.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

template <class T>
std::shared_ptr<const Volume<T>> cut(const Volume<T>& volume, int across, const glm::dvec3& point) {
  const Geometry& g = volume.geometry;
  const int last = g.dims[across] - 1;
  glm::ivec3 first(0);
  first[across] = int(std::clamp(std::floor(g.toIndex(point)[across]), 0.0, double(last)));
  Geometry part = g;
  part.origin = g.toWorld(glm::dvec3(first));
  part.dims[across] = std::min(2, g.dims[across] - first[across]);
  auto slices = std::make_shared<Volume<T>>(Volume<T>::unset(part));
  for (int k = 0; k < part.dims.z; ++k)
    for (int j = 0; j < part.dims.y; ++j)
      std::copy_n(&volume.at(first.x, first.y + j, first.z + k), part.dims.x, &slices->at(0, j, k));
  return slices;
}

}  // namespace

std::shared_ptr<const Volume<float>> slicesAround(const std::shared_ptr<const Volume<float>>& volume,
                                                  int across, const glm::dvec3& point) {
  return volume ? cut(*volume, across, point) : nullptr;
}

std::shared_ptr<const Volume<std::uint8_t>> slicesAround(
    const std::shared_ptr<const Volume<std::uint8_t>>& volume, int across, const glm::dvec3& point) {
  return volume ? cut(*volume, across, point) : nullptr;
}

}  // namespace sonoskin
