#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// HoleLoop: the border of a hole.
//   points   counter-clockwise seen from outside
//   normals  of the surface beyond each side, that from point i to point i + 1; unit
struct HoleLoop {
  std::vector<glm::dvec3> points, normals;
};

// triangulateLoop: triangles that span a hole, without new points.
//   isAllowed  whether a side may join two points: one that the surface has already would end in four triangles
//   method     the least largest angle between neighbours, the surface beyond included, then the least area, by
//              dynamic programming [Liepa 2003, after Barequet and Sharir]; longer loops are first cut by short
//              chords into loops of 128 points at most (ours)
//   output     indices into the points; empty if there is no such triangulation
//   cost       128 points: 20 ms
std::vector<Triangle> triangulateLoop(const HoleLoop& loop,
                                      const std::function<bool(std::uint32_t, std::uint32_t)>& isAllowed);

}  // namespace sonoskin
