#pragma once

#include <optional>

#include "core/mesh/search/signed_distance.h"

namespace sonoskin {

// WallField: a wall of even thickness behind an open surface, as a function that is negative inside. Keeps a reference
// to the mesh.
//   front    the surface itself
//   back     what is `thickness` away from it
//   rim      across the surface, along its border
//   method   max(height, -height - thickness, distance beyond the rim); near the wall's border that is a distance
class WallField {
 public:
  // surface: manifold, oriented, not empty; cell: the finest detail that matters, mm
  WallField(const Mesh& surface, float thickness, float cell);

  struct Value {
    float field = 0;     // < 0 inside; mm near the wall's border
    float distance = 0;  // from the surface
    std::uint32_t triangle = 0;
  };
  Value at(const glm::vec3& query, std::uint32_t guess = 0) const;

 private:
  void makeRim(const Mesh& surface);
  std::optional<float> beyondRim(const glm::vec3& query, const SignedDistance::Place& place) const;

  float thickness_, cell_;
  SignedDistance surface_;
  Mesh rim_;  // the sides of all borders as triangles without area; normals lead out of the surface, along it
  std::optional<TriangleTree> rimTree_;
};

}  // namespace sonoskin
