#pragma once

#include <cstdint>
#include <vector>

#include "core/skin/diffusion_places.h"
#include "core/skin/skin_surface.h"

namespace sonoskin {

// SurfacePlace: a place of a mesh, by a triangle and the weights of its corners.
struct SurfacePlace {
  std::uint32_t triangle = 0;
  glm::vec3 weights{0};
};

// shownTexels: numbers of the texels that an atlas owns or that lie beside one that it does: looks between texels read no
// others, but for corners of charts that own none. Skirts are not among them. Both in the order of the maps.
std::vector<std::uint32_t> shownTexels(const AtlasMaps& maps);
// coveredTexels: of all that show anything.
std::vector<std::uint32_t> coveredTexels(const AtlasMaps& maps);

// placeOfTexel: where on the texel's triangle its middle lies, or its nearest point.
SurfacePlace placeOfTexel(const SkinSurface& surface, std::uint32_t texel);

// inLocalOrder: the places as positions and normals of the mesh.
DiffusionPlaces inLocalOrder(const Mesh& mesh, const std::vector<SurfacePlace>& places);

}  // namespace sonoskin
