#pragma once

#include "render/gl/texture.h"

namespace sonoskin {

// DetailTile: pores and fine lines of skin as a block that repeats in all three directions.
//   texture     xyz: gradient of the height (mm per mm, so no unit); w: height, mm
//   meanSlope   mean squared slope along one direction
struct DetailTile {
  static constexpr int kSide = 64;
  static constexpr float kLength = 4;  // mm
  gl::Texture texture;
  float meanSlope = 0;
};

// makeDetailTile: dimples (pores and the roots of fine hair, 0.4 mm apart, 12 um deep) between lines that cross.
//                                                                                [theory/skin.md, 10.3]
//   cost     30 ms
DetailTile makeDetailTile();

}  // namespace sonoskin
