#pragma once

#include <cmath>

#include "core/mesh/mesh.h"
#include "tests/fuzz/fuzz_input.h"

namespace sonoskin::fuzz {

// claimSound: what core/mesh/mesh.h promises of every mesh, whatever file it came from.
inline void claimSound(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  const auto share = [](float v) { return v >= 0 && v <= 1; };
  claim(mesh.normals.empty() || mesh.normals.size() == n, "as many normals as positions");
  claim(mesh.visibility.empty() || mesh.visibility.size() == n, "as many visibilities as positions");
  claim(mesh.measured.empty() || mesh.measured.size() == n, "as many measured as positions");
  claim(mesh.labels.empty() || mesh.labels.size() == n, "as many labels as positions");
  claim(mesh.cornerUvs.empty() || mesh.cornerUvs.size() == mesh.triangles.size(),
        "corners of every triangle");
  for (const glm::vec3& p : mesh.positions)
    claim(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "positions are finite");
  for (const Triangle& t : mesh.triangles) claim(t[0] < n && t[1] < n && t[2] < n, "indices have a vertex");
  for (const glm::vec3& normal : mesh.normals)
    claim(std::abs(glm::length(normal) - 1) < 2e-3f, "normals have length 1");
  for (const float v : mesh.visibility) claim(share(v), "visibility is a share");
  for (const float v : mesh.measured) claim(share(v), "measured is a share");
  for (const auto& corners : mesh.cornerUvs)
    for (const glm::vec2& uv : corners)
      claim(std::isfinite(uv.x) && std::isfinite(uv.y), "texture coordinates are finite");
}

}  // namespace sonoskin::fuzz
