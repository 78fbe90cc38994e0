#pragma once

#include <algorithm>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace sonoskin {

// Tile: a box of voxels, [first, last) along each axis. A solver can leave out tiles in which nothing changes.
struct Tile {
  glm::ivec3 first, last;
};

// Smaller tiles leave out more of the volume, but memory likes long rows: of sizes from 48x8x8 to 512x8x16 this one was
// fastest. 96x16x8 wrote a tenth fewer voxels and took twice as long for each.
inline constexpr glm::ivec3 kTileSize(512, 16, 8);

// tileCounts: tiles along each axis.
inline glm::ivec3 tileCounts(const glm::ivec3& dims) { return (dims + kTileSize - 1) / kTileSize; }

// tilesOf: tiles that fill the volume, i fastest; the last ones of each axis may be smaller.
inline std::vector<Tile> tilesOf(const glm::ivec3& dims) {
  const glm::ivec3 counts = tileCounts(dims);
  std::vector<Tile> tiles;
  for (int c = 0; c < counts.z; ++c)
    for (int b = 0; b < counts.y; ++b)
      for (int a = 0; a < counts.x; ++a) {
        const glm::ivec3 first = glm::ivec3(a, b, c) * kTileSize;
        tiles.push_back({first, glm::min(first + kTileSize, dims)});
      }
  return tiles;
}

// TileRow: called with (j, k, Ku) for each row of a tile's voxels; Ku has one value per voxel of the row.
using TileRow = std::function<void(int j, int k, const float* ku)>;

}  // namespace sonoskin
