#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Relief: what lies behind a surface, seen along the columns of a grid (its third axis), as a function that is negative
// inside. It begins a given depth behind the first place of the surface on each column, never before, and fills
// whatever undercuts there are.
struct Relief {
  glm::ivec2 dims{0};
  float cell = 0;
  std::vector<float> start;   // mm along the column at which the inside begins; infinite far from the surface
  std::vector<float> beyond;  // mm outside the surface's outline, negative inside
  std::vector<float> slope;   // 1 / sqrt(1 + |gradient of start|²): turns depths into distances

  // field: at `along` mm of column (i, j).
  float field(int i, int j, float along) const {
    const std::size_t column = std::size_t(j) * std::size_t(dims.x) + std::size_t(i);
    return std::max((start[column] - along) * slope[column], beyond[column]);
  }
};

// makeRelief:
//   grid     cubic cells; the surface lies within it
//   depth    mm behind the first place at which the inside begins
//   method   triangles drawn into the columns, the nearest kept; beginnings taken from the deepest of 5 x 5 columns and
//            blurred as widely, so that the inside stays behind the surface at steep places
//   errors   Cancelled
Relief makeRelief(const Mesh& surface, const Geometry& grid, float depth, const Progress& progress = {});

}  // namespace sonoskin
