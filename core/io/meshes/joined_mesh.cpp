#include "core/io/meshes/joined_mesh.h"

#include <xxhash.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace sonoskin {
namespace {

// What does not spread over a picture is something else, such as a number for each vertex.
bool hasArea(const std::vector<std::array<glm::vec2, 3>>& uvs) {
  return std::any_of(uvs.begin(), uvs.end(), [](const std::array<glm::vec2, 3>& c) {
    const glm::vec2 a = c[1] - c[0], b = c[2] - c[0];
    return a.x * b.y != a.y * b.x;
  });
}

}  // namespace

std::size_t JoinedMesh::Hash::operator()(const glm::vec3& p) const {
  return std::size_t(XXH3_64bits(&p, sizeof p));
}

std::uint32_t JoinedMesh::vertex(const glm::vec3& position, const glm::vec3& normal) {
  require(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z),
          "{} has a vertex at no finite position; get a fresh copy.", path_.string());
  const glm::vec3 place = position + 0.0f;  // -0 and 0 are one place
  const auto [found, isNew] = places_.try_emplace(place, std::uint32_t(mesh_.positions.size()));
  if (isNew) {
    mesh_.positions.push_back(place);
    mesh_.normals.emplace_back(0);
  }
  mesh_.normals[found->second] += normal;
  return found->second;
}

void JoinedMesh::triangle(const Triangle& corners, const std::array<glm::vec2, 3>* uvs) {
  mesh_.triangles.push_back(corners);
  if (uvs) mesh_.cornerUvs.push_back(*uvs);
}

Mesh JoinedMesh::take() {
  bool allGiven = true;
  for (glm::vec3& n : mesh_.normals) {
    const float length = glm::length(n);
    allGiven = allGiven && length > 0;
    n /= length > 0 ? length : 1;
  }
  if (!allGiven) mesh_.normals.clear();
  if (mesh_.cornerUvs.size() != mesh_.triangles.size() || !hasArea(mesh_.cornerUvs)) mesh_.cornerUvs.clear();
  places_.clear();
  return std::move(mesh_);
}

}  // namespace sonoskin
