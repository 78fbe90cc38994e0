#include "core/mesh/components.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/view_shares.h"

namespace sonoskin {
namespace {

double triangleArea(const Mesh& mesh, const Triangle& t) {
  const glm::dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

constexpr std::uint32_t kNone = 0xffffffffu;

// For every vertex the rank of its piece by area; kNone for vertices without a triangle.
struct Ranking {
  std::vector<std::uint32_t> ofVertex;
  std::size_t pieces = 0;
};

Ranking rankPieces(const Mesh& mesh) {
  DisjointSets sets(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::vector<std::uint32_t> pieceOfRoot(mesh.positions.size(), kNone);
  std::vector<double> area;
  for (const Triangle& t : mesh.triangles) {
    std::uint32_t& piece = pieceOfRoot[sets.root(t[0])];
    if (piece == kNone) {
      piece = std::uint32_t(area.size());
      area.push_back(0);
    }
    area[piece] += triangleArea(mesh, t);
  }
  std::vector<std::uint32_t> order(area.size()), rank(area.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
  for (std::uint32_t r = 0; r < order.size(); ++r) rank[order[r]] = r;

  Ranking result{std::vector<std::uint32_t>(mesh.positions.size(), kNone), area.size()};
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    if (const std::uint32_t piece = pieceOfRoot[sets.root(v)]; piece != kNone)
      result.ofVertex[v] = rank[piece];
  return result;
}

}  // namespace

std::vector<Mesh> splitPieces(const Mesh& mesh, const Progress& progress) {
  const Ranking rank = rankPieces(mesh);
  progress.update(0.5);
  std::vector<Mesh> pieces(rank.pieces);
  std::vector<std::uint32_t> number(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (rank.ofVertex[v] == kNone) continue;
    Mesh& piece = pieces[rank.ofVertex[v]];
    number[v] = std::uint32_t(piece.positions.size());
    piece.positions.push_back(mesh.positions[v]);
    if (!mesh.normals.empty()) piece.normals.push_back(mesh.normals[v]);
    if (!mesh.visibility.empty()) piece.visibility.push_back(mesh.visibility[v]);
    if (!mesh.labels.empty()) piece.labels.push_back(mesh.labels[v]);
    if (!mesh.measured.empty()) piece.measured.push_back(mesh.measured[v]);
  }
  progress.update(0.8);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    Mesh& piece = pieces[rank.ofVertex[t[0]]];
    piece.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    if (!mesh.cornerUvs.empty()) piece.cornerUvs.push_back(mesh.cornerUvs[i]);
  }
  progress.update(1);
  return pieces;
}

std::vector<std::uint32_t> pieceOfVertices(const Mesh& mesh) { return rankPieces(mesh).ofVertex; }

Mesh joinPieces(const std::vector<Mesh>& pieces) {
  Mesh whole;
  for (const Mesh& piece : pieces) {
    const auto first = std::uint32_t(whole.positions.size());
    whole.positions.insert(whole.positions.end(), piece.positions.begin(), piece.positions.end());
    whole.normals.insert(whole.normals.end(), piece.normals.begin(), piece.normals.end());
    whole.visibility.insert(whole.visibility.end(), piece.visibility.begin(), piece.visibility.end());
    whole.labels.insert(whole.labels.end(), piece.labels.begin(), piece.labels.end());
    whole.measured.insert(whole.measured.end(), piece.measured.begin(), piece.measured.end());
    whole.cornerUvs.insert(whole.cornerUvs.end(), piece.cornerUvs.begin(), piece.cornerUvs.end());
    for (const Triangle& t : piece.triangles)
      whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  if (whole.normals.size() != whole.positions.size()) whole.normals.clear();
  if (whole.visibility.size() != whole.positions.size()) whole.visibility.clear();
  if (whole.labels.size() != whole.positions.size()) whole.labels.clear();
  if (whole.measured.size() != whole.positions.size()) whole.measured.clear();
  if (whole.cornerUvs.size() != whole.triangles.size()) whole.cornerUvs.clear();
  return whole;
}

std::size_t pieceNearest(const std::vector<Mesh>& pieces, const glm::vec3& point) {
  require(!pieces.empty(), "There is no surface to choose from.");
  std::size_t nearest = 0;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (const Triangle& t : pieces[p].triangles) {
      const auto& x = pieces[p].positions;
      const glm::vec3 d = closestPointOnTriangle(point, x[t[0]], x[t[1]], x[t[2]]).position - point;
      if (glm::dot(d, d) < least) {
        least = glm::dot(d, d);
        nearest = p;
      }
    }
  return nearest;
}

std::vector<double> viewShares(const std::vector<Mesh>& pieces, const Beam& beam, const glm::dvec3& middle) {
  std::vector<std::uint32_t> pieceOf;
  for (std::uint32_t p = 0; p < pieces.size(); ++p)
    pieceOf.insert(pieceOf.end(), pieces[p].triangles.size(), p);
  return viewShares(joinPieces(pieces), pieceOf, pieces.size(), beam, middle).centred;
}

}  // namespace sonoskin
