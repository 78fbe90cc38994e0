#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/skin/diffusion_target.h"
#include "core/skin/skin_surface.h"
#include "core/skin/surface_samples.h"

namespace sonoskin::accuracy {

// SkinLighting: what falls on a place of the surface that faces along a normal.
using SkinLighting = std::function<float(const glm::vec3& position, const glm::vec3& normal)>;

// SkinPlace: a place of a mesh, by a triangle and the weights of its corners.
struct SkinPlace {
  std::uint32_t triangle = 0;
  glm::vec3 weights{0};
};

// SkinPlaces: where the light is compared.
struct SkinPlaces {
  std::vector<SkinPlace> places;
  std::vector<glm::vec3> positions, normals;
};

// spreadPlaces: about `count` places, every so many square mm, in no relation to the triangles.
SkinPlaces spreadPlaces(const Mesh& mesh, std::size_t count);

// placesFor: how many that are for one in a quarter of a square mm: half a mm apart.
std::size_t placesFor(const Mesh& mesh);

// targetsOf: the places with what falls on them.
std::vector<DiffusionTarget> targetsOf(const SkinPlaces& places, const SkinLighting& lighting);

// Seams: places every half mm along the borders between charts, as each of the two charts has them.
struct Seams {
  std::vector<std::array<SkinPlace, 2>> sides;
  std::vector<glm::vec3> positions;
};
Seams findSeams(const Mesh& mesh, const Atlas& atlas);

// nearSeams: for each position whether a seam is less than `distance` mm away.
std::vector<bool> nearSeams(const std::vector<glm::vec3>& positions, const Seams& seams, float distance);

}  // namespace sonoskin::accuracy
