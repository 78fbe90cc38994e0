#include "core/rbf/surface/brick_mesher.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/mesh/iso/marching_cubes_table.h"

namespace sonoskin {
namespace {

constexpr std::size_t kBricksPerTask = 128;
constexpr float kFromNode = 1e-3f;  // cells: a vertex at a node would make triangles without area

// A brick and its upper neighbours; bit a of the index: one brick further along axis a.
using Neighbours = std::array<std::int32_t, 8>;

// The cut edges that start at a brick's nodes, by axis, and the number of the first vertex on each axis' edges.
struct BrickCuts {
  std::array<NodeSet, 3> edges{};
  std::array<std::uint32_t, 3> first{};

  std::uint32_t vertex(std::size_t axis, int node) const {
    return first[axis] + std::uint32_t(std::popcount(edges[axis] & ((NodeSet(1) << node) - 1)));
  }
};

// The cells that start at a brick's nodes: by corner c of the cube whether it is inside; and which are crossed.
struct BrickCells {
  std::array<NodeSet, 8> inside;
  NodeSet crossed;

  std::size_t caseOf(int node) const {
    std::size_t result = 0;
    for (std::size_t c = 0; c < 8; ++c) result |= std::size_t((inside[c] >> node) & 1) << c;
    return result;
  }
};

// Where the vertex on a cube's edge is: the neighbour that owns it, its node there, and the axis.
struct EdgeOwner {
  std::uint8_t neighbour, node, axis;
};

using EdgeOwners = std::array<std::array<EdgeOwner, kCubeEdges>, kBrickNodes>;
constexpr EdgeOwners kEdgeOwners = [] {
  EdgeOwners owners{};
  for (int n = 0; n < int(kBrickNodes); ++n)
    for (int e = 0; e < kCubeEdges; ++e) {
      const int corner = edgeStart(e);
      const int x = n % 4 + (corner & 1), y = n / 4 % 4 + ((corner >> 1) & 1), z = n / 16 + (corner >> 2);
      owners[std::size_t(n)][std::size_t(e)] = {std::uint8_t(x / 4 + y / 4 * 2 + z / 4 * 4),
                                                std::uint8_t(brickNode(x % 4, y % 4, z % 4)),
                                                std::uint8_t(edgeAxis(e))};
    }
  return owners;
}();

// Calls f(node) for the nodes of a set, ascending.
template <class F>
void forEachNode(NodeSet nodes, F&& f) {
  for (; nodes; nodes &= nodes - 1) f(std::countr_zero(nodes));
}

class Mesher {
 public:
  explicit Mesher(const BrickField& field) : field_(field), cuts_(field.bricks.size()) {}

  BrickMesh run(const Progress& progress) {
    const std::size_t bricks = field_.bricks.size();
    firstTriangle_.assign(bricks + 1, 0);
    result_.firstVertex.assign(bricks + 1, 0);
    forEachBrick(progress.part(0, 0.4), [&](std::size_t b) { findCuts(b); });
    numberAll();
    result_.mesh.positions.resize(result_.firstVertex.back());
    result_.coverage.resize(result_.firstVertex.back());
    result_.mesh.triangles.resize(firstTriangle_.back());
    forEachBrick(progress.part(0.4, 1), [&](std::size_t b) { fill(b); });
    return std::move(result_);
  }

 private:
  template <class F>
  void forEachBrick(const Progress& progress, F&& f) const {
    parallelItems(field_.bricks.size(), kBricksPerTask, f, progress);
  }

  Neighbours neighboursOf(std::size_t brick) const {
    Neighbours result;
    for (int n = 0; n < 8; ++n)
      result[std::size_t(n)] =
          field_.map.find(field_.bricks[brick] + glm::ivec3(n & 1, (n >> 1) & 1, n >> 2));
    return result;
  }

  // The set's bits at the eight corners of the cells that start at a brick's nodes.
  static std::array<NodeSet, 8> atCorners(const std::vector<NodeSet>& sets, const Neighbours& neighbours) {
    std::array<NodeSet, 8> b;
    for (std::size_t n = 0; n < 8; ++n) b[n] = neighbours[n] >= 0 ? sets[std::size_t(neighbours[n])] : 0;
    // Axis by axis: afterwards b[n] belongs to corner n along the axes so far, and to brick n along the others.
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t n = 0; n < 8; ++n)
        if (const std::size_t step = std::size_t(1) << axis; (n & step) == 0)
          b[n + step] = shifted(b[n], b[n + step], axis);
    return b;
  }

  static BrickCells cellsOf(const std::array<NodeSet, 8>& inside, const std::array<NodeSet, 8>& defined) {
    NodeSet any = 0, all = ~NodeSet(0), known = ~NodeSet(0);
    for (std::size_t c = 0; c < 8; ++c) any |= inside[c], all &= inside[c], known &= defined[c];
    return {inside, any & ~all & known};
  }

  void findCuts(std::size_t brick) {
    const Neighbours neighbours = neighboursOf(brick);
    const auto inside = atCorners(field_.inside, neighbours), defined = atCorners(field_.defined, neighbours);
    BrickCuts& cuts = cuts_[brick];
    std::uint32_t vertices = 0, triangles = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t next = std::size_t(1) << axis;
      cuts.edges[axis] = (inside[0] ^ inside[next]) & defined[0] & defined[next];
      vertices += std::uint32_t(std::popcount(cuts.edges[axis]));
    }
    const BrickCells cells = cellsOf(inside, defined);
    forEachNode(cells.crossed, [&](int node) { triangles += kCubeCases[cells.caseOf(node)].count; });
    result_.firstVertex[brick + 1] = vertices;
    firstTriangle_[brick + 1] = triangles;
  }

  void numberAll() {
    std::size_t vertices = 0;
    for (std::size_t b = 0; b < cuts_.size(); ++b) {
      vertices += result_.firstVertex[b + 1];
      require(vertices < 0xffffffffu, "The mesh is too fine: lower its resolution.");
      result_.firstVertex[b + 1] += result_.firstVertex[b];
      firstTriangle_[b + 1] += firstTriangle_[b];
      std::uint32_t next = result_.firstVertex[b];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        cuts_[b].first[axis] = next;
        next += std::uint32_t(std::popcount(cuts_[b].edges[axis]));
      }
    }
  }

  // Makes a brick's vertices and the triangles of its cells.
  void fill(std::size_t brick) {
    if (result_.firstVertex[brick] == result_.firstVertex[brick + 1] &&
        firstTriangle_[brick] == firstTriangle_[brick + 1])
      return;
    const Neighbours neighbours = neighboursOf(brick);
    for (int axis = 0; axis < 3; ++axis) fillVertices(brick, neighbours[std::size_t(1) << axis], axis);
    std::array<BrickCuts, 8> cuts;
    for (std::size_t n = 0; n < 8; ++n)
      if (neighbours[n] >= 0) cuts[n] = cuts_[std::size_t(neighbours[n])];
    const BrickCells cells =
        cellsOf(atCorners(field_.inside, neighbours), atCorners(field_.defined, neighbours));
    Triangle* out = result_.mesh.triangles.data() + firstTriangle_[brick];
    forEachNode(cells.crossed, [&](int node) {
      const CubeCase& cube = kCubeCases[cells.caseOf(node)];
      for (std::size_t t = 0; t < cube.count; ++t, ++out)
        for (std::size_t i = 0; i < 3; ++i) {
          const EdgeOwner owner = kEdgeOwners[std::size_t(node)][cube.triangles[t][i]];
          (*out)[i] = cuts[owner.neighbour].vertex(owner.axis, owner.node);
        }
    });
  }

  // The vertices on a brick's edges along one axis; `next` is the brick in which the outermost end.
  void fillVertices(std::size_t brick, std::int32_t next, int axis) {
    const BrickCuts& cuts = cuts_[brick];
    const glm::vec3 corner = field_.corner(brick);
    const int stride = kNodeStride[std::size_t(axis)];
    const NodeSet last = kLayer[std::size_t(axis)][kBrickEdge - 1];
    std::size_t vertex = cuts.first[std::size_t(axis)];
    forEachNode(cuts.edges[std::size_t(axis)], [&](int node) {
      const std::size_t from = brick * kBrickNodes + std::size_t(node);
      const std::size_t to = (last >> node) & 1
                                 ? std::size_t(next) * kBrickNodes + std::size_t(node - 3 * stride)
                                 : from + std::size_t(stride);
      const float a = field_.value[from],
                  t = std::clamp(a / (a - field_.value[to]), kFromNode, 1 - kFromNode);
      glm::vec3 place(nodePlace(node));
      place[axis] += t;
      result_.mesh.positions[vertex] = corner + field_.cell * place;
      result_.coverage[vertex] = field_.coverage[from] + t * (field_.coverage[to] - field_.coverage[from]);
      ++vertex;
    });
  }

  const BrickField& field_;
  std::vector<BrickCuts> cuts_;
  std::vector<std::size_t> firstTriangle_;
  BrickMesh result_;
};

}  // namespace

BrickMesh meshBricks(const BrickField& field, const Progress& progress) {
  return Mesher(field).run(progress);
}

}  // namespace sonoskin
