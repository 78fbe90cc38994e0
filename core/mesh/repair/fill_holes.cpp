#include "core/mesh/repair/fill_holes.h"

#include <algorithm>
#include <ranges>
#include <unordered_map>
#include <unordered_set>

#include "core/base/parallel.h"
#include "core/mesh/components.h"
#include "core/mesh/half_edges.h"
#include "core/mesh/repair/hole_fairing.h"
#include "core/mesh/repair/hole_refinement.h"
#include "core/mesh/repair/hole_triangulation.h"
#include "core/mesh/search/self_intersections.h"
#include "core/mesh/search/triangle_tree.h"

namespace sonoskin {
namespace {

using Loop = std::vector<std::uint32_t>;  // half-edges of a border, in order

// The edges that join two vertices of borders: a patch must not add a second one.
class BorderEdges {
 public:
  BorderEdges(const Mesh& mesh, const std::vector<Loop>& loops) {
    std::vector<bool> isBorder(mesh.positions.size(), false);
    for (const Loop& loop : loops)
      for (const std::uint32_t h : loop) isBorder[originOf(mesh.triangles, h)] = true;
    for (const Triangle& t : mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (isBorder[t[i]] && isBorder[t[(i + 1) % 3]]) edges_.insert(keyOf(t[i], t[(i + 1) % 3]));
  }
  bool has(std::uint32_t a, std::uint32_t b) const { return edges_.contains(keyOf(a, b)); }

 private:
  static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
  }
  std::unordered_set<std::uint64_t> edges_;
};

double sizeAcross(const std::vector<glm::vec3>& points, double enough) {
  const Box box = boundingBox(points);
  const glm::vec3 sides = box.max - box.min;
  // Between the longest side of the box and its diagonal: most loops need no closer look.
  if (double(std::max({sides.x, sides.y, sides.z})) > enough) return double(box.diagonal());
  if (double(box.diagonal()) <= enough) return double(box.diagonal());
  float squared = 0;
  for (const glm::vec3& a : points)
    for (const glm::vec3& b : points) squared = std::max(squared, glm::dot(a - b, a - b));
  return std::sqrt(double(squared));
}

// A border: its size across, and the diagonal of its box, mm.
struct Extent {
  double size = 0, diagonal = 0;
};

Extent extentOf(const Mesh& mesh, const Loop& loop, double enough) {
  std::vector<glm::vec3> points;
  for (const std::uint32_t h : loop) points.push_back(mesh.positions[originOf(mesh.triangles, h)]);
  return {sizeAcross(points, enough), double(boundingBox(points).diagonal())};
}

// Areas of the pieces, mm².
std::vector<double> areasOf(const Mesh& mesh, const std::vector<std::uint32_t>& piece) {
  std::vector<double> areas;
  for (const auto& [a, b, c] : mesh.triangles) {
    if (piece[a] >= areas.size()) areas.resize(piece[a] + 1, 0);
    areas[piece[a]] += 0.5 * double(glm::length(glm::cross(mesh.positions[b] - mesh.positions[a],
                                                           mesh.positions[c] - mesh.positions[a])));
  }
  return areas;
}

// The largest border of every piece is no hole, or only where it is small beside the piece.
std::vector<bool> areOutlines(const Mesh& mesh, const std::vector<Loop>& loops,
                              const std::vector<Extent>& extents, Outline outline) {
  constexpr double kSmall = 0.1;  // squared diagonal of the border's box by the area of the piece
  const std::vector<std::uint32_t> piece = pieceOfVertices(mesh);
  const std::vector<double> areas = areasOf(mesh, piece);
  std::vector<std::size_t> largest(areas.size(), loops.size());
  const auto pieceOf = [&](std::size_t l) { return piece[originOf(mesh.triangles, loops[l][0])]; };
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::size_t& most = largest[pieceOf(l)];
    if (most == loops.size() || extents[l].diagonal > extents[most].diagonal) most = l;
  }
  std::vector<bool> isOutline(loops.size(), false);
  for (const std::size_t l : largest) {
    if (l == loops.size()) continue;
    const bool isSmall = extents[l].diagonal * extents[l].diagonal < kSmall * areas[pieceOf(l)];
    isOutline[l] = outline == Outline::keep || !isSmall;
  }
  return isOutline;
}

// The borders that are holes.
std::vector<Loop> holesOf(const Mesh& mesh, std::vector<Loop> loops, const HoleOptions& options) {
  std::erase_if(loops, [](const Loop& l) { return l.size() < 3; });
  std::vector<Extent> extents;
  bool anySmall = false;
  for (const Loop& l : loops) {
    extents.push_back(extentOf(mesh, l, options.largest));
    anySmall = anySmall || extents.back().size <= options.largest;
  }
  if (!anySmall) return {};
  std::vector<bool> isOutline(loops.size(), false);
  if (options.outline != Outline::fill) isOutline = areOutlines(mesh, loops, extents, options.outline);
  std::vector<Loop> holes;
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (!isOutline[l] && extents[l].size <= options.largest) holes.push_back(std::move(loops[l]));
  return holes;
}

// The triangles that a patch may meet: those around the holes.
Mesh surroundingsOf(const Mesh& mesh, const std::vector<Loop>& holes) {
  std::vector<Box> boxes;
  for (const Loop& loop : holes) {
    std::vector<glm::vec3> points;
    for (const std::uint32_t h : loop) points.push_back(mesh.positions[originOf(mesh.triangles, h)]);
    const Box box = boundingBox(points);
    boxes.push_back({box.min - box.diagonal(), box.max + box.diagonal()});
  }
  Mesh near;
  near.positions = mesh.positions;
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Box box{glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
    if (std::any_of(boxes.begin(), boxes.end(), [&](const Box& other) { return overlap(box, other); }))
      near.triangles.push_back(t);
  }
  return near;
}

glm::dvec3 unitNormal(const Mesh& mesh, const Triangle& t) {
  const glm::dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double length = glm::length(n);
  return length > 0 ? n / length : glm::dvec3(0);
}

Corners cornersOf(const Mesh& mesh, const Triangle& t) {
  return {glm::dvec3(mesh.positions[t[0]]), glm::dvec3(mesh.positions[t[1]]),
          glm::dvec3(mesh.positions[t[2]])};
}

Mesh meshOf(const HolePatch& patch) {
  Mesh mesh;
  for (const glm::dvec3& p : patch.points) mesh.positions.emplace_back(p);
  mesh.triangles = patch.triangles;
  return mesh;
}

// Surroundings: the triangles that a patch must not cross.
struct Surroundings {
  const Mesh& mesh;
  const TriangleTree& tree;
};

// One hole on its way to being filled. Its loop runs against the border, so that the patch is seen from outside.
class Hole {
 public:
  Hole(const Mesh& mesh, const std::vector<std::uint32_t>& opposite, const Loop& border)
      : mesh_(mesh), opposite_(opposite), border_(border) {
    const std::size_t n = border.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t h = border[n - 1 - i];
      vertices_.push_back(originOf(mesh.triangles, nextHalfEdge(h)));
      loop_.points.emplace_back(mesh.positions[vertices_.back()]);
      loop_.normals.push_back(unitNormal(mesh, mesh.triangles[h / 3]));
    }
  }

  const std::vector<std::uint32_t>& vertices() const { return vertices_; }

  // crossing: whether a patch that crosses the surface is better than none.
  HolePatch fill(const BorderEdges& edges, const Surroundings& around, bool crossing,
                 const Progress& progress) const {
    const auto isAllowed = [&](std::uint32_t i, std::uint32_t j) {
      return vertices_[i] != vertices_[j] && !edges.has(vertices_[i], vertices_[j]);
    };
    HolePatch flat{loop_.points, triangulateLoop(loop_, isAllowed)};
    std::vector<double> sizes = sideLengths();
    if (flat.triangles.empty()) spanFromTheMiddle(flat, sizes);
    refinePatch(flat, sizes, isAllowed, progress.part(0, 0.4));
    // Where the surface folds at the border, going on smoothly may lead through it, and so may a membrane.
    HolePatch plate = flat, membrane = flat;
    fair(plate, Fairing::thinPlate, progress.part(0.4, 0.7));
    const std::size_t ofPlate = countCrossings(plate, around);
    if (ofPlate == 0) return plate;
    fair(membrane, Fairing::membrane, progress.part(0.7, 1));
    const std::size_t ofMembrane = countCrossings(membrane, around);
    if (ofMembrane == 0) return membrane;
    const std::size_t ofFlat = countCrossings(flat, around);
    if (ofFlat == 0) return flat;
    if (!crossing) return {};
    return ofFlat < std::min(ofPlate, ofMembrane) ? flat : ofMembrane < ofPlate ? membrane : plate;
  }

 private:
  std::vector<double> sideLengths() const {
    const std::size_t n = loop_.points.size();
    std::vector<double> sizes(n);
    for (std::size_t i = 0; i < n; ++i)
      sizes[i] = 0.5 * (glm::distance(loop_.points[i], loop_.points[(i + 1) % n]) +
                        glm::distance(loop_.points[i], loop_.points[(i + n - 1) % n]));
    return sizes;
  }

  // Where chords are all taken, a fan around a new point needs none.
  void spanFromTheMiddle(HolePatch& patch, std::vector<double>& sizes) const {
    const auto n = std::uint32_t(loop_.points.size());
    glm::dvec3 middle(0);
    double size = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      middle += loop_.points[i] / double(n);
      size += sizes[i] / double(n);
      patch.triangles.push_back({i, (i + 1) % n, n});
    }
    patch.points.push_back(middle);
    sizes.push_back(size);
  }

  // With itself and with the mesh.
  std::size_t countCrossings(const HolePatch& patch, const Surroundings& around) const {
    const Mesh alone = meshOf(patch);
    std::size_t count = countSelfIntersections(alone);
    for (const Triangle& t : alone.triangles) {
      const Corners corners = cornersOf(alone, t);
      Box box{alone.positions[t[0]], alone.positions[t[0]]};
      for (const std::uint32_t v : t)
        box = {glm::min(box.min, alone.positions[v]), glm::max(box.max, alone.positions[v])};
      around.tree.forEachNear(box, [&](std::uint32_t other) {
        count += trianglesCross(corners, cornersOf(around.mesh, around.mesh.triangles[other]));
      });
    }
    return count;
  }

  void fair(HolePatch& patch, Fairing fairing, const Progress& progress) const {
    FairingMesh local{patch.points, {}, patch.triangles};
    local.role.assign(patch.points.size(), FairingMesh::Role::free);
    std::fill_n(local.role.begin(), vertices_.size(), FairingMesh::Role::border);
    addRing(local);
    fairPoints(local, fairing, progress);
    std::copy_n(local.points.begin(), patch.points.size(), patch.points.begin());
  }

  // The triangles of the mesh around the loop's vertices.
  void addRing(FairingMesh& local) const {
    std::unordered_map<std::uint32_t, std::uint32_t> number;
    for (std::size_t i = 0; i < vertices_.size(); ++i) number.emplace(vertices_[i], std::uint32_t(i));
    std::unordered_set<std::uint32_t> seen;
    for (const std::uint32_t side : border_)
      for (std::uint32_t h = side; h != kNoHalfEdge; h = opposite_[nextHalfEdge(nextHalfEdge(h))]) {
        if (!seen.insert(h / 3).second) continue;
        Triangle t = mesh_.triangles[h / 3];
        for (std::uint32_t& v : t) {
          const auto [found, isNew] = number.try_emplace(v, std::uint32_t(local.points.size()));
          if (isNew) {
            local.points.emplace_back(mesh_.positions[v]);
            local.role.push_back(FairingMesh::Role::ring);
          }
          v = found->second;
        }
        local.triangles.push_back(t);
      }
  }

  const Mesh& mesh_;
  const std::vector<std::uint32_t>& opposite_;
  const Loop& border_;
  std::vector<std::uint32_t> vertices_;
  HoleLoop loop_;
};

// Adds a patch to the mesh; the vertices of its loop are there already.
void append(Mesh& mesh, const std::vector<std::uint32_t>& loop, const HolePatch& patch) {
  std::vector<std::uint32_t> number = loop;
  for (std::size_t i = loop.size(); i < patch.points.size(); ++i) {
    number.push_back(std::uint32_t(mesh.positions.size()));
    mesh.positions.emplace_back(patch.points[i]);
  }
  for (const Triangle& t : patch.triangles)
    mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
}

// Takes away patches that cross one before them. None crosses itself.
void dropCrossing(std::vector<HolePatch>& patches) {
  std::vector<Mesh> kept;
  std::vector<Box> boxes;
  for (HolePatch& patch : patches) {
    if (patch.triangles.empty()) continue;
    const Mesh mesh = meshOf(patch);
    const Box box = boundingBox(mesh.positions);
    const auto crosses = [&](std::size_t k) {
      return overlap(box, boxes[k]) && countSelfIntersections(joinPieces({mesh, kept[k]})) > 0;
    };
    const auto numbers = std::views::iota(std::size_t(0), kept.size());
    if (std::ranges::any_of(numbers, crosses)) {
      patch = {};
      continue;
    }
    kept.push_back(mesh);
    boxes.push_back(box);
  }
}

// Normals, visibility, labels and measured of the vertices from `first` on.
void completeVertices(Mesh& mesh, std::size_t first) {
  if (!mesh.visibility.empty()) mesh.visibility.resize(mesh.positions.size(), 0.f);
  if (!mesh.labels.empty()) mesh.labels.resize(mesh.positions.size(), 0);
  if (!mesh.measured.empty()) mesh.measured.resize(mesh.positions.size(), 0.f);
  if (mesh.normals.empty()) return;
  Mesh shape;
  shape.positions = mesh.positions;
  shape.triangles = mesh.triangles;
  computeNormals(shape);
  mesh.normals.insert(mesh.normals.end(), shape.normals.begin() + std::ptrdiff_t(first), shape.normals.end());
}

}  // namespace

Mesh fillHoles(const Mesh& mesh, const HoleOptions& options, const Progress& progress) {
  Mesh filled = mesh;
  const std::vector<std::uint32_t> opposite = splitFans(filled);
  progress.update(0.05);
  const std::vector<Loop> holes = holesOf(filled, borderLoops(filled.triangles, opposite), options);
  if (holes.empty()) return filled;
  filled.cornerUvs.clear();  // no picture has a place for what is new
  const BorderEdges edges(filled, holes);
  const Mesh before = filled, near = surroundingsOf(before, holes);
  const TriangleTree tree(near);
  progress.update(0.1);
  // Patches do not meet: every vertex of a border lies on one loop, and a chord joins vertices of one loop.
  std::vector<HolePatch> patches(holes.size());
  parallelFor(
      std::ptrdiff_t(holes.size()),
      [&](std::ptrdiff_t l) {
        patches[std::size_t(l)] = Hole(before, opposite, holes[std::size_t(l)])
                                      .fill(edges, {near, tree}, options.crossing, progress.cancelOnly());
      },
      progress.part(0.1, 0.95));
  if (!options.crossing) dropCrossing(patches);
  for (std::size_t l = 0; l < holes.size(); ++l)
    append(filled, Hole(before, opposite, holes[l]).vertices(), patches[l]);
  completeVertices(filled, before.positions.size());
  progress.update(1);
  return filled;
}

}  // namespace sonoskin
