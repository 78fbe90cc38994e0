#pragma once

#include <algorithm>
#include <glm/glm.hpp>

#include "core/volume/volume.h"

namespace sonoskin {

// sampleTrilinear: the value at a position in voxel indices; the border's value beyond the border.
//   volume   at least 2 voxels along each axis
template <class T>
float sampleTrilinear(const Volume<T>& volume, const glm::vec3& index) {
  const glm::ivec3 dims = volume.geometry.dims;
  const glm::vec3 p = glm::clamp(index, glm::vec3(0), glm::vec3(dims - 1));
  const glm::ivec3 base = glm::min(glm::ivec3(p), dims - 2);
  const glm::vec3 t = p - glm::vec3(base);
  const T* corner = &volume.at(base.x, base.y, base.z);
  const std::ptrdiff_t row = dims.x, plane = row * dims.y;
  const auto alongI = [&](const T* v) { return float(v[0]) + t.x * (float(v[1]) - float(v[0])); };
  const auto alongJ = [&](const T* v) {
    const float low = alongI(v);
    return low + t.y * (alongI(v + row) - low);
  };
  const float low = alongJ(corner);
  return low + t.z * (alongJ(corner + plane) - low);
}

// gradientAt: central differences at an inner voxel, per unit of the smallest spacing, along i, j, k.
//   i, j, k  at least 1 from every border
inline glm::vec3 gradientAt(const Volume<float>& volume, const glm::vec3& axisScale, std::size_t index) {
  const float* v = volume.data.data() + index;
  const std::ptrdiff_t row = volume.geometry.dims.x, plane = row * volume.geometry.dims.y;
  return 0.5f * axisScale * glm::vec3(v[1] - v[-1], v[row] - v[-row], v[plane] - v[-plane]);
}

}  // namespace sonoskin
