#include "core/mesh/repair/smooth.h"

#include <cmath>
#include <numeric>

#include "core/base/parallel_blocks.h"
#include "core/mesh/half_edges.h"

namespace sonoskin {
namespace {

constexpr float kNormalWidth = 0.35f;
constexpr int kVertexSteps = 10;
constexpr std::size_t kPerTask = 4096;

// The triangles at each vertex, in ascending order.
struct VertexTriangles {
  std::vector<std::uint32_t> start, triangles;

  explicit VertexTriangles(const Mesh& mesh)
      : start(mesh.positions.size() + 2, 0), triangles(3 * mesh.triangles.size()) {
    for (const Triangle& t : mesh.triangles)
      for (const std::uint32_t v : t) ++start[v + 2];
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::uint32_t v : mesh.triangles[t]) triangles[start[v + 1]++] = t;
  }
  template <class F>
  void forEach(std::uint32_t vertex, const F& f) const {
    for (std::uint32_t i = start[vertex]; i < start[vertex + 1]; ++i) f(triangles[i]);
  }
};

// Face: what the filter knows of a triangle.
struct Face {
  glm::vec3 middle, normal;
  float area;
};

class Smoother {
 public:
  explicit Smoother(Mesh& mesh)
      : mesh_(mesh), around_(mesh), faces_(mesh.triangles.size()), next_(faces_.size()) {
    findBorders();
  }

  void step(const Progress& progress) {
    measureFaces(progress);
    const float width = meanNeighbourDistance();
    parallelItems(
        faces_.size(), kPerTask, [&](std::size_t t) { next_[t] = filteredNormal(t, width); }, progress);
    for (std::size_t t = 0; t < faces_.size(); ++t) faces_[t].normal = next_[t];
    for (int i = 0; i < kVertexSteps; ++i) moveVertices(progress);
  }

 private:
  // Tangents of borders: from the vertex before to the one after; zero inside.
  void findBorders() {
    tangents_.assign(mesh_.positions.size(), glm::vec3(0));
    isBorder_.assign(mesh_.positions.size(), false);
    const auto opposite = oppositeHalfEdges(mesh_.triangles, mesh_.positions.size());
    for (std::uint32_t h = 0; h < opposite.size(); ++h) {
      if (opposite[h] != kNoHalfEdge) continue;
      const std::uint32_t a = originOf(mesh_.triangles, h), b = originOf(mesh_.triangles, nextHalfEdge(h));
      for (const std::uint32_t v : {a, b}) {
        isBorder_[v] = true;
        tangents_[v] += mesh_.positions[b] - mesh_.positions[a];
      }
    }
    for (glm::vec3& t : tangents_)
      if (const float length = glm::length(t); length > 0) t /= length;
  }

  void measureFaces(const Progress& progress) {
    parallelItems(
        faces_.size(), kPerTask,
        [&](std::size_t t) {
          const auto& [a, b, c] = mesh_.triangles[t];
          const glm::vec3 &x = mesh_.positions[a], &y = mesh_.positions[b], &z = mesh_.positions[c];
          const glm::vec3 n = glm::cross(y - x, z - x);
          const float length = glm::length(n);
          faces_[t] = {(x + y + z) / 3.f, length > 0 ? n / length : glm::vec3(0), 0.5f * length};
        },
        progress);
  }

  // By the sides of the triangles: middles of neighbours are two thirds of a height apart, about 0.58 sides.
  float meanNeighbourDistance() const {
    double sum = 0;
    for (const Triangle& t : mesh_.triangles)
      sum += double(glm::distance(mesh_.positions[t[0]], mesh_.positions[t[1]]));
    return float(0.58 * sum / double(mesh_.triangles.size()));
  }

  glm::vec3 filteredNormal(std::size_t t, float width) const {
    const Face& face = faces_[t];
    const float distanceScale = -0.5f / (width * width), normalScale = -0.5f / (kNormalWidth * kNormalWidth);
    glm::vec3 sum(0);
    for (const std::uint32_t v : mesh_.triangles[t])
      around_.forEach(v, [&](std::uint32_t other) {  // those at two common corners count twice, being nearer
        const Face& o = faces_[other];
        const glm::vec3 d = o.middle - face.middle, n = o.normal - face.normal;
        sum += o.area * std::exp(distanceScale * glm::dot(d, d) + normalScale * glm::dot(n, n)) * o.normal;
      });
    const float length = glm::length(sum);
    return length > 0 ? sum / length : face.normal;
  }

  glm::vec3 middleOf(std::uint32_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return (mesh_.positions[a] + mesh_.positions[b] + mesh_.positions[c]) / 3.f;
  }

  // Every vertex toward the planes through its triangles' middles across the filtered normals.
  void moveVertices(const Progress& progress) {
    parallelItems(
        faces_.size(), kPerTask, [&](std::size_t t) { faces_[t].middle = middleOf(std::uint32_t(t)); },
        progress);
    parallelItems(
        mesh_.positions.size(), kPerTask,
        [&](std::size_t v) {
          glm::vec3 move(0);
          float count = 0;
          around_.forEach(std::uint32_t(v), [&](std::uint32_t t) {
            move += faces_[t].normal * glm::dot(faces_[t].normal, faces_[t].middle - mesh_.positions[v]);
            ++count;
          });
          if (count == 0) return;
          move /= count;
          if (isBorder_[v]) move = tangents_[v] * glm::dot(tangents_[v], move);
          mesh_.positions[v] += move;
        },
        progress);
  }

  Mesh& mesh_;
  VertexTriangles around_;
  std::vector<Face> faces_;
  std::vector<glm::vec3> next_, tangents_;
  std::vector<bool> isBorder_;
};

}  // namespace

void smoothMesh(Mesh& mesh, int steps, const Progress& progress) {
  if (steps <= 0 || mesh.empty()) return;
  Smoother smoother(mesh);
  for (int i = 0; i < steps; ++i) {
    progress.update(double(i) / steps);
    smoother.step(progress.cancelOnly());
  }
  if (!mesh.normals.empty()) computeNormals(mesh);
  progress.update(1);
}

}  // namespace sonoskin
