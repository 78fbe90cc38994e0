#pragma once

#include <array>
#include <filesystem>
#include <unordered_map>

#include "core/mesh/mesh.h"

namespace sonoskin {

// JoinedMesh: collects the triangles of a file whose parts have corners of their own: vertices at equal positions become
// one, for a surface that falls apart at seams of a picture or at every edge is none to us.
class JoinedMesh {
 public:
  explicit JoinedMesh(const std::filesystem::path& path) : path_(path) {}

  // vertex: the index of the vertex at a place. normal: of any length, 0 where the file gives none.
  //   errors  Error: the place is not finite
  std::uint32_t vertex(const glm::vec3& position, const glm::vec3& normal = glm::vec3(0));
  // triangle: of vertices that are there, with its texture coordinates where the file gives some.
  void triangle(const Triangle& corners, const std::array<glm::vec2, 3>* uvs = nullptr);
  std::size_t triangles() const { return mesh_.triangles.size(); }
  // take: the whole. Normals of length 1 where all vertices have them; texture coordinates where all triangles have them
  // and they span an area.
  Mesh take();

 private:
  struct Hash {
    std::size_t operator()(const glm::vec3& p) const;
  };
  const std::filesystem::path& path_;
  Mesh mesh_;
  std::unordered_map<glm::vec3, std::uint32_t, Hash> places_;
};

}  // namespace sonoskin
