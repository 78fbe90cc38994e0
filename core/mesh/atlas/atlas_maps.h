#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/atlas/atlas.h"
#include "core/mesh/facets.h"

namespace sonoskin {

// AtlasMaps: the surface as pictures over an atlas; row 0 is the lowest, x fastest.
//   position   xyz: world mm; w: 1 owned, 0.5 skirt or a texel of rim, 0 nothing there
//   normal     xyz: unit; w: mean curvature in 1/mm, positive where the surface is convex
//   occlusion  xyz: unit, the mean direction of open sky; w: 0 (closed in) to 1 (open)
//   stretch    mm per texel along u and v, from positions smoothed over 0.5 mm; never 0             [theory/skin.md, 3.4]
//   triangle   of the mesh that the texel shows
struct AtlasMaps {
  glm::ivec2 size{0};
  std::vector<glm::vec4> position, normal, occlusion;
  std::vector<glm::vec2> stretch;
  std::vector<std::uint32_t> triangle;
};

// SurfaceTraits: what the maps hold of each vertex besides its place.
//   occlusion  as in AtlasMaps; curvature 1/mm
struct SurfaceTraits {
  std::vector<glm::vec4> occlusion;
  std::vector<float> curvature;
};

// measureTraits: occlusion by `directions` parallel depth pictures, curvature over `radius` mm.
//   input   facets      of the mesh whose vertices are asked about
//           occluders   what hides the sky: the mesh, and perhaps more
//   cost    350,000 triangles, 128 directions: 0.3 s of CPU
//   errors  Cancelled
SurfaceTraits measureTraits(const Facets& facets, const Mesh& occluders, int directions, double radius,
                            const Progress& progress = {});
SurfaceTraits measureTraits(const Mesh& mesh, int directions = 128, double radius = 2,
                            const Progress& progress = {});

// bakeAtlas: fills the maps. Skirts first, owners over them; where owners lie over each other, the one under the more
// open sky. Beyond a chart that ends its last triangles go on for one texel, for those who look between texels.
//   input   facets   of a mesh with normals
//   cost    2 million texels: 0.3 s on two cores
//   errors  Error: the mesh has no normals; traits or atlas belong to another mesh. Cancelled
AtlasMaps bakeAtlas(const Facets& facets, const SurfaceTraits& traits, const Atlas& atlas,
                    const Progress& progress = {});
AtlasMaps bakeAtlas(const Mesh& mesh, const SurfaceTraits& traits, const Atlas& atlas,
                    const Progress& progress = {});

}  // namespace sonoskin
