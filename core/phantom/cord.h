#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/phantom/sdf.h"

namespace sonoskin {

// Cord: the umbilical cord: a tube along a curve, with the three vessels as twisted ridges.
struct Cord {
  struct Node {
    glm::vec3 at, side;  // on the axis; unit, across it, turning as little as the curve allows
    float along;         // mm from the first one
  };
  std::vector<Node> axis;  // empty: no cord
  float radius = 6;        // mm, to the ridges
  sdf::Reach reach;        // a ball around it
};

// makeCord: along a curve through points (Catmull-Rom, uniform).
//   guide   at least 4 points, mm; the curve goes from the second to the last but one
Cord makeCord(const std::vector<glm::vec3>& guide, float radius);

// cordDistance: signed distance to the cord's surface, within some 15 %; large without one, and estimated
// beyond 10 mm from it.
float cordDistance(const Cord& cord, const glm::vec3& p);

}  // namespace sonoskin
