#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// FairingMesh: a patch and a strip of the surface around it.
//   role   of each point: free to move; border: fixed, all its triangles are here; ring: fixed
struct FairingMesh {
  enum class Role : std::uint8_t { free, border, ring };
  std::vector<glm::dvec3> points;
  std::vector<Role> role;
  std::vector<Triangle> triangles;
};

// Fairing: how a patch is bent.
//   thinPlate   goes on smoothly from the surface around it: min Σ_i |Δx_i|² A_i over free and border points
//   membrane    as small as a film of soap: Δx_i = 0 at free points
// Δ: the cotangents' Laplacian, A_i: the area around a point                             [Botsch, Kobbelt 2004]
enum class Fairing { thinPlate, membrane };

// fairPoints: moves the free points; twice, the second time with the cotangents of the first result.
//   cost     10,000 points: 0.1 s
//   errors   Cancelled
void fairPoints(FairingMesh& mesh, Fairing fairing, const Progress& progress = {});

}  // namespace sonoskin
