#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// HolePatch: the triangles that fill a hole.
//   points   first those of the loop, then new ones
struct HolePatch {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;
};

// refinePatch: adds points until the triangles are as small as those around the hole.
//   sizes      the length of sides wanted at each point of the loop, mm
//   isAllowed  whether a side may join two points of the loop
//   method     triangles split at their centre, sides swapped toward Delaunay's   [Liepa 2003]; beyond some 10,000
//              points the size grows toward the middle (ours)
//   errors     Cancelled
void refinePatch(HolePatch& patch, std::vector<double> sizes,
                 const std::function<bool(std::uint32_t, std::uint32_t)>& isAllowed,
                 const Progress& progress = {});

}  // namespace sonoskin
