#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "core/base/large_array.h"

namespace sonoskin {

// Geometry: where the voxels of a volume lie.
//   dims       voxels along i, j, k; i is fastest in memory
//   spacing    mm between voxel centres along i, j, k; > 0
//   origin     world position of the centre of voxel (0,0,0), mm, LPS
//   direction  columns are the world directions of i, j, k; orthonormal, may mirror
struct Geometry {
  glm::ivec3 dims{0};
  glm::dvec3 spacing{1};
  glm::dvec3 origin{0};
  glm::dmat3 direction{1};

  std::size_t voxels() const { return std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z); }
  std::size_t index(int i, int j, int k) const {
    return (std::size_t(k) * std::size_t(dims.y) + std::size_t(j)) * std::size_t(dims.x) + std::size_t(i);
  }
  glm::dvec3 toWorld(const glm::dvec3& index) const { return origin + direction * (spacing * index); }
  glm::dvec3 toIndex(const glm::dvec3& world) const {
    return (glm::transpose(direction) * (world - origin)) / spacing;
  }
  // toWorldDirection: the world direction of a gradient taken per mm along i, j, k; not normalised.
  glm::dvec3 toWorldDirection(const glm::dvec3& alongAxesMm) const { return direction * alongAxesMm; }
  bool mirrors() const { return glm::determinant(direction) < 0; }
  double minSpacing() const { return glm::min(spacing.x, glm::min(spacing.y, spacing.z)); }
  // axisScale: smallest spacing / spacing, per axis; turns voxel differences into differences per smallest
  // spacing.
  glm::vec3 axisScale() const { return glm::vec3(minSpacing() / spacing); }
};

// Volume: a regular grid of values, with its place in the world. data.size() == geometry.voxels().
template <class T>
struct Volume {
  Geometry geometry;
  LargeArray<T> data;

  Volume() = default;
  explicit Volume(const Geometry& g, T value = T{}) : geometry(g), data(g.voxels(), value) {}
  // unset: for those who write every voxel themselves.
  static Volume unset(const Geometry& g) {
    Volume volume;
    volume.geometry = g;
    volume.data.resize(g.voxels());
    return volume;
  }

  T& at(int i, int j, int k) { return data[geometry.index(i, j, k)]; }
  const T& at(int i, int j, int k) const { return data[geometry.index(i, j, k)]; }
};

}  // namespace sonoskin
