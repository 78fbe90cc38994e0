#include "core/mesh/components.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/closest_point.h"

namespace sonoskin {
namespace {

// Vertices as disjoint sets; the smallest vertex of a set stands for it.
class VertexSets {
 public:
  explicit VertexSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

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
  VertexSets sets(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::vector<std::uint32_t> pieceOfRoot(mesh.positions.size(), kNone);
  std::vector<double> area;
  for (const Triangle& t : mesh.triangles) {
    std::uint32_t& piece = pieceOfRoot[sets.find(t[0])];
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
    if (const std::uint32_t piece = pieceOfRoot[sets.find(v)]; piece != kNone)
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

namespace {

// Where a point lies among the beams: across them, relative to the middle beam, and along them.
struct BeamPlace {
  glm::dvec2 across{0};  // radians around an apex (equidistant from the middle beam), mm for parallel beams
  double depth = 0;      // mm
};

class BeamFrame {
 public:
  BeamFrame(const Beam& beam, const glm::dvec3& middle)
      : apex_(beam.apex), origin_(beam.apex.value_or(middle)), forward_(beam.directionAt(middle)) {
    const glm::dvec3 helper = std::abs(forward_.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    right_ = glm::normalize(glm::cross(forward_, helper));
    up_ = glm::cross(right_, forward_);
  }
  BeamPlace place(const glm::vec3& world) const {
    const glm::dvec3 d = glm::dvec3(world) - origin_;
    const glm::dvec2 lateral(glm::dot(d, right_), glm::dot(d, up_));
    if (!apex_) return {lateral, glm::dot(d, forward_)};
    const double off = glm::length(lateral);
    const double angle = std::atan2(off, glm::dot(d, forward_));
    return {off > 0 ? lateral * (angle / off) : lateral, glm::length(d)};
  }

 private:
  std::optional<glm::dvec3> apex_;
  glm::dvec3 origin_, forward_, right_, up_;
};

// For each of a square of beams the piece that it meets first.
class FirstHits {
 public:
  static constexpr int kBeams = 256;

  explicit FirstHits(double halfExtent)
      : scale_(kBeams / (2 * halfExtent)),
        piece_(std::size_t(kBeams) * kBeams, kNone),
        depth_(std::size_t(kBeams) * kBeams, std::numeric_limits<double>::infinity()) {}

  // Fills the beams that a triangle crosses, by samples half a beam apart.
  void draw(std::uint32_t piece, const BeamPlace& a, const BeamPlace& b, const BeamPlace& c) {
    const double edge = std::max({glm::distance(a.across, b.across), glm::distance(b.across, c.across),
                                  glm::distance(c.across, a.across)});
    const int steps = std::clamp(int(std::ceil(2 * edge * scale_)), 1, 2 * kBeams);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const double u = double(i) / steps, v = double(j) / steps, w = 1 - u - v;
        plot(piece, w * a.across + u * b.across + v * c.across, w * a.depth + u * b.depth + v * c.depth);
      }
  }

  // Adds to each piece's score the weights of the beams that it is the first on.
  void addScores(std::vector<double>& scores) const {
    constexpr double kWidth = 0.35;
    for (int y = 0; y < kBeams; ++y)
      for (int x = 0; x < kBeams; ++x) {
        const std::uint32_t piece = piece_[std::size_t(y) * kBeams + std::size_t(x)];
        if (piece == kNone) continue;
        const glm::dvec2 off = (glm::dvec2(x, y) + 0.5) * (2.0 / kBeams) - 1.0;
        scores[piece] += std::exp(-glm::dot(off, off) / (2 * kWidth * kWidth));
      }
  }

 private:
  void plot(std::uint32_t piece, const glm::dvec2& across, double depth) {
    const glm::ivec2 beam = glm::clamp(glm::ivec2(glm::floor(across * scale_)) + kBeams / 2, 0, kBeams - 1);
    const std::size_t i = std::size_t(beam.y) * kBeams + std::size_t(beam.x);
    if (depth >= depth_[i]) return;
    depth_[i] = depth;
    piece_[i] = piece;
  }

  double scale_;  // beams per unit across
  std::vector<std::uint32_t> piece_;
  std::vector<double> depth_;
};

}  // namespace

std::vector<double> viewShares(const std::vector<Mesh>& pieces, const Beam& beam, const glm::dvec3& middle) {
  const BeamFrame frame(beam, middle);
  std::vector<std::vector<BeamPlace>> places(pieces.size());
  double halfExtent = 1e-9;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (const glm::vec3& x : pieces[p].positions) {
      const BeamPlace place = frame.place(x);
      halfExtent = std::max({halfExtent, std::abs(place.across.x), std::abs(place.across.y)});
      places[p].push_back(place);
    }
  FirstHits hits(halfExtent);
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (const Triangle& t : pieces[p].triangles)
      hits.draw(std::uint32_t(p), places[p][t[0]], places[p][t[1]], places[p][t[2]]);
  std::vector<double> scores(pieces.size(), 0);
  hits.addScores(scores);
  const double best = pieces.empty() ? 0 : *std::max_element(scores.begin(), scores.end());
  for (double& score : scores) score = best > 0 ? score / best : 1;
  return scores;
}

}  // namespace sonoskin
