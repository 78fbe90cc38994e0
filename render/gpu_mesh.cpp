#include "render/gpu_mesh.h"

#include <glad/gl.h>

namespace sonoskin {
namespace {

std::vector<glm::vec3> normalsOf(const Mesh& mesh) {
  Mesh copy;
  copy.positions = mesh.positions;
  copy.triangles = mesh.triangles;
  computeNormals(copy);
  return copy.normals;
}

// How well each vertex is known; empty where the mesh does not say.
std::vector<float> knownOf(const Mesh& mesh) {
  if (mesh.visibility.empty()) return mesh.measured;
  std::vector<float> known = mesh.visibility;
  for (std::size_t v = 0; v < mesh.measured.size(); ++v) known[v] *= mesh.measured[v];
  return known;
}

}  // namespace

void GpuMesh::set(std::shared_ptr<const Mesh> mesh) {
  if (mesh == mesh_) return;
  *this = GpuMesh();
  if (mesh && !mesh->empty()) upload(*mesh);
  mesh_ = std::move(mesh);
}

void GpuMesh::upload(const Mesh& mesh) {
  box_ = boundingBox(mesh.positions);
  positions_ = gl::Buffer(std::span<const glm::vec3>(mesh.positions));
  normals_ = mesh.normals.empty() ? gl::Buffer(std::span<const glm::vec3>(normalsOf(mesh)))
                                  : gl::Buffer(std::span<const glm::vec3>(mesh.normals));
  indices_ = gl::Buffer(std::span<const Triangle>(mesh.triangles));
  vertexArray_.emplace();
  vertexArray_->attribute(0, 3, positions_);
  vertexArray_->attribute(1, 3, normals_);
  if (const std::vector<float> known = knownOf(mesh); !known.empty()) {
    known_ = gl::Buffer(std::span<const float>(known));
    vertexArray_->attribute(2, 1, known_);
  }
  vertexArray_->indices(indices_);
}

void GpuMesh::draw() const {
  if (empty()) return;
  glBindVertexArray(vertexArray_->name());
  glVertexAttrib1f(2, 1.0f);  // for meshes that do not say how well they are known
  glDrawElements(GL_TRIANGLES, GLsizei(mesh_->triangles.size() * 3), GL_UNSIGNED_INT, nullptr);
}

}  // namespace sonoskin
