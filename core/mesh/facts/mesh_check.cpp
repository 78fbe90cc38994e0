#include "core/mesh/facts/mesh_check.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"

namespace sonoskin {
namespace {

// One directed side of a triangle.
struct HalfEdge {
  std::uint32_t low, high;  // its vertices in ascending order
  std::uint32_t triangle;
  bool ascending;  // runs from low to high
};

constexpr std::size_t kBetweenLooks =
    1 << 15;  // pieces of work between two looks for a cancel: some milliseconds

// By their lower vertex, the higher one, and the triangle: counted into place by the first, so that only few are sorted
// at a time.
std::vector<HalfEdge> sortedHalfEdges(const Mesh& mesh, const Progress& progress) {
  std::vector<std::size_t> next(mesh.positions.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++next[std::min(t[i], t[(i + 1) % 3]) + 1];
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) next[v + 1] += next[v];
  std::vector<HalfEdge> halfEdges(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % kBetweenLooks == 0) progress.throwIfCancelled();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      halfEdges[next[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), std::uint32_t(t), a < b};
    }
  }
  auto first = halfEdges.begin();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {  // next[v] is now where the edges of v end
    if (v % kBetweenLooks == 0) progress.throwIfCancelled();
    const auto last = halfEdges.begin() + std::ptrdiff_t(next[v]);
    std::sort(first, last, [](const HalfEdge& a, const HalfEdge& b) {
      return a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    first = last;
  }
  return halfEdges;
}

std::uint32_t cornerOf(const Mesh& mesh, std::uint32_t triangle, std::uint32_t vertex) {
  const Triangle& t = mesh.triangles[triangle];
  return 3 * triangle + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
}

// What is found: numbers, and the vertices with something wrong, some of them twice.
struct Findings {
  MeshCheck check;
  std::vector<std::uint32_t> defective;
};

// Classifies the run of half-edges [first, last) that lie on one edge and joins the corners across it: corners at one
// vertex, so that a vertex with one fan of triangles ends as one set.
void countEdge(const Mesh& mesh, const HalfEdge* first, const HalfEdge* last, DisjointSets& corners,
               Findings& findings) {
  const auto uses = last - first;
  MeshCheck& check = findings.check;
  ++check.edges;
  if (uses == 1) ++check.boundaryEdges;
  if (uses > 2) ++check.nonManifoldEdges;
  const bool misoriented = uses == 2 && first[0].ascending == first[1].ascending;
  check.misorientedEdges += misoriented;
  if (uses > 2 || misoriented) findings.defective.insert(findings.defective.end(), {first->low, first->high});
  for (const HalfEdge* h = first + 1; h < last; ++h)
    for (const std::uint32_t v : {h->low, h->high})
      corners.join(cornerOf(mesh, first->triangle, v), cornerOf(mesh, h->triangle, v));
}

void countVertices(const Mesh& mesh, DisjointSets& corners, Findings& findings) {
  std::vector<std::uint32_t> fans(mesh.positions.size(), 0);
  for (std::uint32_t c = 0; c < 3 * mesh.triangles.size(); ++c)
    if (corners.isRoot(c)) ++fans[mesh.triangles[c / 3][c % 3]];
  for (std::uint32_t v = 0; v < fans.size(); ++v) {
    findings.check.usedVertices += fans[v] > 0;
    findings.check.nonManifoldVertices += fans[v] > 1;
    if (fans[v] > 1) findings.defective.push_back(v);
  }
}

bool isDegenerate(const Mesh& mesh, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const glm::dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
  return glm::cross(b - a, c - a) == glm::dvec3(0);
}

Findings inspect(const Mesh& mesh, const Progress& progress) {
  for (const Triangle& t : mesh.triangles)
    require(std::max({t[0], t[1], t[2]}) < mesh.positions.size(),
            "The mesh is damaged: a triangle names a vertex that is not there.");
  Findings findings;
  const std::vector<HalfEdge> halfEdges = sortedHalfEdges(mesh, progress);
  DisjointSets corners(3 * mesh.triangles.size());
  const HalfEdge* const end = halfEdges.data() + halfEdges.size();
  for (const HalfEdge* first = halfEdges.data(); first < end;) {
    const HalfEdge* last = first;
    while (last < end && last->low == first->low && last->high == first->high) ++last;
    countEdge(mesh, first, last, corners, findings);
    if (findings.check.edges % kBetweenLooks == 0) progress.throwIfCancelled();
    first = last;
  }
  countVertices(mesh, corners, findings);
  return findings;
}

}  // namespace

MeshCheck checkMesh(const Mesh& mesh, const Progress& progress) {
  MeshCheck check = inspect(mesh, progress).check;
  for (const Triangle& t : mesh.triangles) check.degenerateTriangles += isDegenerate(mesh, t);
  check.euler = std::ptrdiff_t(check.usedVertices) - std::ptrdiff_t(check.edges) +
                std::ptrdiff_t(mesh.triangles.size());
  return check;
}

std::vector<std::uint32_t> defectiveVertices(const Mesh& mesh) {
  std::vector<std::uint32_t> vertices = inspect(mesh, {}).defective;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double enclosedVolume(const Mesh& mesh) {
  double six = 0;
  for (const Triangle& t : mesh.triangles)
    six += glm::dot(glm::dvec3(mesh.positions[t[0]]),
                    glm::cross(glm::dvec3(mesh.positions[t[1]]), glm::dvec3(mesh.positions[t[2]])));
  return six / 6;
}

}  // namespace sonoskin
