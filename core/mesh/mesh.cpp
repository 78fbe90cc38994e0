#include "core/mesh/mesh.h"

namespace sonoskin {
namespace {

// Twice the area times the unit normal.
glm::vec3 areaNormal(const Mesh& mesh, const Triangle& t) {
  const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  return glm::cross(b - a, c - a);
}

}  // namespace

Box boundingBox(const std::vector<glm::vec3>& positions) {
  if (positions.empty()) return {};
  Box box{positions.front(), positions.front()};
  for (const glm::vec3& p : positions) {
    box.min = glm::min(box.min, p);
    box.max = glm::max(box.max, p);
  }
  return box;
}

double surfaceArea(const Mesh& mesh) {
  double twice = 0;
  for (const Triangle& t : mesh.triangles) twice += double(glm::length(areaNormal(mesh, t)));
  return 0.5 * twice;
}

void computeNormals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 n = areaNormal(mesh, t);
    for (const std::uint32_t v : t) mesh.normals[v] += n;
  }
  for (glm::vec3& n : mesh.normals) {
    const float length = glm::length(n);
    n = length > 0 ? n / length : glm::vec3(0, 0, 1);
  }
}

}  // namespace sonoskin
