#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// splitPolygon: a face with any number of corners as triangles, which keep its winding.
//   input    corners  in their order; three or more
//   output   n - 2 triangles of indices into `corners`: a fan from the first where the face is convex, else by cutting off
//            ears [Meisters 1975] in the plane of Newell's normal; a fan, too, where there are none, as of a face that
//            crosses itself
//   cost     mostly n^2 where it is concave; a fan from 1000 corners on
std::vector<Triangle> splitPolygon(std::span<const glm::vec3> corners);

}  // namespace sonoskin
