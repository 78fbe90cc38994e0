#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "core/rbf/brick.h"

namespace sonoskin {

// ImplicitFunction: a function S whose zero set is a surface, as extractIsoSurface asks for it: near the surface only.
// World mm; S > 0 outside. Both members are called from several threads.
//   cell         edge of the lattice that it was made for, mm
//   reach        mm from the points within which the surface may lie
//   sampleBrick  S in mm (NaN where it is undefined) and the coverage Σφ at corner + cell (x, y, z) for the nodes of a
//                brick, in their order
//   gradients    a vector along ∇S at each position; all positions lie within brickReach(cell) of `centre`
struct ImplicitFunction {
  float cell = 1, reach = 0;
  std::function<void(const glm::vec3& corner, float* value, float* coverage)> sampleBrick;
  std::function<void(const glm::vec3& centre, std::span<const glm::vec3> positions, glm::vec3* gradients)>
      gradients;
};

}  // namespace sonoskin
