#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace sonoskin {

using Triangle = std::array<std::uint32_t, 3>;

// Mesh: a triangle surface. World mm, LPS; triangles counter-clockwise seen from outside, normals outward
// (toward the probe's side, the fluid).
//   normals      unit; as many as positions, or empty
//   visibility   0 (the probe cannot have seen it) to 1; as many as positions, or empty where it is unknown
//   measured     0 (filled in, where nothing was measured) to 1 (on data); as many as positions, or empty where it is
//                unknown
//   labels       BodyPart of a simulated truth (core/phantom/phantom.h); as many as positions, or empty
//   triangles    indices into positions
//   cornerUvs    texture coordinates that a file brought: u to the right, v up, 0 to 1 over its picture; one for each
//                triangle's three corners, or empty
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<float> visibility;
  std::vector<Triangle> triangles;
  std::vector<std::array<glm::vec2, 3>> cornerUvs;
  std::vector<float> measured{};
  std::vector<std::uint8_t> labels{};

  bool empty() const { return triangles.empty(); }
};

struct Box {
  glm::vec3 min{0}, max{0};
  glm::vec3 centre() const { return 0.5f * (min + max); }
  float diagonal() const { return glm::length(max - min); }
};

// overlap: whether two boxes have a point in common.
inline bool overlap(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
         a.min.z <= b.max.z && b.min.z <= a.max.z;
}

// boundingBox: the smallest axis-aligned box around the positions; all zero without any.
Box boundingBox(const std::vector<glm::vec3>& positions);

// surfaceArea: mm^2.
double surfaceArea(const Mesh& mesh);

// computeNormals: fills mesh.normals by the area-weighted mean of the adjacent triangles' normals.
void computeNormals(Mesh& mesh);

}  // namespace sonoskin
