#pragma once

#include <array>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// Segment: a piece of a line, from end to end, world mm.
using Segment = std::array<glm::vec3, 2>;

// planeSection: where a surface meets a plane.
//   input    point   on the plane, world mm
//            normal  unit
//   output   a segment for each triangle that has corners on both sides; a corner on the plane counts as behind it, so that
//            the pieces of a closed surface make closed lines
//   cost     one look at each triangle; 1 ms for 350,000
std::vector<Segment> planeSection(const Mesh& mesh, const glm::dvec3& point, const glm::dvec3& normal);

}  // namespace sonoskin
