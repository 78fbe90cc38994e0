#include "core/volume/resample.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// How many voxels of each axis make one: 2, or 1 where the axis is coarse or a single voxel.
glm::ivec3 blockOf(const Geometry& geometry) {
  glm::ivec3 block(1);
  for (int axis = 0; axis < 3; ++axis)
    if (geometry.dims[axis] > 3 && geometry.spacing[axis] < 1.6 * geometry.minSpacing()) block[axis] = 2;
  return block;
}

Geometry coarser(const Geometry& fine, const glm::ivec3& block) {
  Geometry coarse = fine;
  coarse.dims = fine.dims / block;  // an odd last voxel is left out
  coarse.spacing = fine.spacing * glm::dvec3(block);
  coarse.origin = fine.toWorld(0.5 * glm::dvec3(block - 1));
  return coarse;
}

}  // namespace

Volume<float> halveResolution(const Volume<float>& volume, const Progress& progress) {
  const glm::ivec3 block = blockOf(volume.geometry);
  Volume<float> result(coarser(volume.geometry, block));
  const glm::ivec3 dims = result.geometry.dims;
  const float share = 1.0f / float(block.x * block.y * block.z);
  parallelFor(
      dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < dims.y; ++j) {
          float* out = &result.at(0, j, int(k));
          for (int dk = 0; dk < block.z; ++dk)
            for (int dj = 0; dj < block.y; ++dj) {
              const float* in = &volume.at(0, j * block.y + dj, int(k) * block.z + dk);
              for (int i = 0; i < dims.x; ++i)
                for (int di = 0; di < block.x; ++di) out[i] += share * in[i * block.x + di];
            }
        }
      },
      progress);
  return result;
}

Volume<std::uint8_t> halveMask(const Volume<std::uint8_t>& mask, const Progress& progress) {
  const glm::ivec3 block = blockOf(mask.geometry);
  Volume<std::uint8_t> result(coarser(mask.geometry, block), 1);
  const glm::ivec3 dims = result.geometry.dims;
  parallelFor(
      dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < dims.y * block.y; ++j)
          for (int dk = 0; dk < block.z; ++dk) {
            std::uint8_t* out = &result.at(0, j / block.y, int(k));
            const std::uint8_t* in = &mask.at(0, j, int(k) * block.z + dk);
            for (int i = 0; i < dims.x * block.x; ++i) out[i / block.x] &= in[i] != 0;
          }
      },
      progress);
  return result;
}

template <class T>
Volume<T> cropVolume(const Volume<T>& volume, const glm::ivec3& first, const glm::ivec3& dims) {
  const Geometry& g = volume.geometry;
  require(glm::all(glm::greaterThan(dims, glm::ivec3(0))) &&
              glm::all(glm::greaterThanEqual(first, glm::ivec3(0))) &&
              glm::all(glm::lessThanEqual(first + dims, g.dims)),
          "the part of the volume to be cut out is empty or not inside the volume");
  Geometry cut = g;
  cut.dims = dims;
  cut.origin = g.toWorld(glm::dvec3(first));
  Volume<T> result(cut);
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j) {
      const T* row = &volume.at(first.x, first.y + j, first.z + k);
      std::copy(row, row + dims.x, &result.at(0, j, k));
    }
  return result;
}

template Volume<float> cropVolume(const Volume<float>&, const glm::ivec3&, const glm::ivec3&);
template Volume<std::uint8_t> cropVolume(const Volume<std::uint8_t>&, const glm::ivec3&, const glm::ivec3&);

}  // namespace sonoskin
