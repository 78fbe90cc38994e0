#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// DiffusionTarget: a place of the surface where the light that comes out is asked for.
//   irradiance   what falls on it: the answer of Gaussians that are narrower than the samples tell apart
struct DiffusionTarget {
  glm::vec3 position{0}, normal{0, 0, 1}, irradiance{0};
};

// Reach: which light comes out at a place. local: that of surface which faces about the same way, all that a blur in an
// atlas can know of; full: also what passes through thin parts.                         [theory/skin.md, 6.1]
enum class Reach { local, full };

// isLocal: whether light may spread between two places without passing through the body.
constexpr float kLocalCosine = 0.1f;  // of their normals
inline bool isLocal(const glm::vec3& normal, const glm::vec3& other) {
  return glm::dot(normal, other) > kLocalCosine;
}

}  // namespace sonoskin
