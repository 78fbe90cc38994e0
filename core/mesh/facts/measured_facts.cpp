#include "core/mesh/facts/measured_facts.h"

#include "core/mesh/components.h"
#include "core/mesh/half_edges.h"

namespace sonoskin {
namespace {

double areaOf(const Mesh& mesh, const Triangle& t) {
  const glm::dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

std::vector<bool> borderVertices(const Mesh& mesh) {
  const std::vector<std::uint32_t> opposite = oppositeHalfEdges(mesh.triangles, mesh.positions.size());
  std::vector<bool> isBorder(mesh.positions.size(), false);
  for (std::uint32_t h = 0; h < opposite.size(); ++h)
    if (opposite[h] == kNoHalfEdge)
      isBorder[originOf(mesh.triangles, h)] = isBorder[originOf(mesh.triangles, nextHalfEdge(h))] = true;
  return isBorder;
}

// The triangles of which nothing was measured.
Mesh unmeasuredPart(const Mesh& mesh) {
  Mesh part;
  part.positions = mesh.positions;
  for (const Triangle& t : mesh.triangles)
    if (mesh.measured[t[0]] <= 0 && mesh.measured[t[1]] <= 0 && mesh.measured[t[2]] <= 0)
      part.triangles.push_back(t);
  return part;
}

}  // namespace

MeasuredFacts measureFilled(const Mesh& mesh) {
  MeasuredFacts facts;
  if (mesh.measured.empty()) {
    facts.measured = surfaceArea(mesh);
    return facts;
  }
  for (const Triangle& t : mesh.triangles) {
    const double sum =
        double(mesh.measured[t[0]]) + double(mesh.measured[t[1]]) + double(mesh.measured[t[2]]);
    facts.measured += sum / 3 * areaOf(mesh, t);
  }
  const Mesh part = unmeasuredPart(mesh);
  if (part.empty()) return facts;
  const std::vector<std::uint32_t> piece = pieceOfVertices(part);
  const std::vector<bool> isBorder = borderVertices(mesh);
  std::vector<double> areas;
  std::vector<bool> isAtBorder;
  for (const Triangle& t : part.triangles) {
    const std::size_t p = piece[t[0]];
    if (p >= areas.size()) {
      areas.resize(p + 1, 0);
      isAtBorder.resize(p + 1, false);
    }
    areas[p] += areaOf(mesh, t);
    if (isBorder[t[0]] || isBorder[t[1]] || isBorder[t[2]]) isAtBorder[p] = true;
  }
  for (std::size_t p = 0; p < areas.size(); ++p) {
    if (isAtBorder[p]) continue;
    facts.filled += areas[p];
    ++facts.holes;
  }
  return facts;
}

}  // namespace sonoskin
