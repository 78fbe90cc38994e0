#pragma once

#include "core/mesh/parts/parts.h"

namespace sonoskin {

// Stroke: a line drawn across a part, world mm.
//   from, to   on the surface; the part is the one at `from`
//   eye        from where it was drawn; not on one line with the others
struct Stroke {
  glm::vec3 from{0}, to{0}, eye{0};
};

// splitPart: parts the part under a stroke into its two sides, and numbers the parts anew.
//   method   what the plane through the stroke and the eye meets, between the stroke's ends and a little beyond, is cut
//            there, through front and back. The rest of the part goes with the side that it is nearer to along the surface
//   output   whether there are two sides now; if not, nothing has changed
//   cost     O(n); 400k triangles in 0.05 s
//   errors   Error: there is no surface
bool splitPart(const Mesh& mesh, SurfaceParts& parts, const Stroke& stroke);

// partAt: the part with the triangle nearest to a place.
//   errors   Error: there is no surface
std::uint32_t partAt(const Mesh& mesh, const SurfaceParts& parts, const glm::vec3& place);

}  // namespace sonoskin
