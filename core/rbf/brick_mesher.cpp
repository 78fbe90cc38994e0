#include "core/rbf/brick_mesher.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/marching_cubes_table.h"

namespace sonoskin {
namespace {

constexpr std::size_t kBricksPerTask = 128;
constexpr std::uint8_t kNoVertex = 255;
constexpr int kPaddedEdge = kBrickEdge + 1;
constexpr std::array<std::size_t, 3> kPaddedStride{1, kPaddedEdge, kPaddedEdge* kPaddedEdge};

// Cut edges of one brick: for each node and axis the vertex among the brick's own, or kNoVertex. And each cell's
// case, 0 where a node is undefined.
struct BrickCuts {
  std::array<std::uint8_t, 3 * kBrickNodes> vertex;
  std::array<std::uint8_t, kBrickNodes> cubeCase;
};

// A brick's nodes and the first layer of its upper neighbours: all nodes of its 4³ cells.
using Padded = std::array<float, kPaddedEdge * kPaddedEdge * kPaddedEdge>;

std::size_t paddedIndex(int x, int y, int z) { return std::size_t((z * kPaddedEdge + y) * kPaddedEdge + x); }

// The brick and its upper neighbours; bit a of the index: one brick further along axis a.
using Neighbours = std::array<std::int32_t, 8>;

Neighbours upperNeighbours(const BrickField& field, std::size_t brick) {
  Neighbours result;
  for (int n = 0; n < 8; ++n)
    result[std::size_t(n)] = field.map.find(field.bricks[brick] + glm::ivec3(n & 1, (n >> 1) & 1, n >> 2));
  return result;
}

void loadPadded(const std::vector<float>& nodes, const Neighbours& neighbours, Padded& padded) {
  for (int z = 0; z < kPaddedEdge; ++z)
    for (int y = 0; y < kPaddedEdge; ++y) {
      const auto row = std::size_t((z % kBrickEdge * kBrickEdge + y % kBrickEdge) * kBrickEdge);
      const auto side = std::size_t((y / kBrickEdge) * 2 + (z / kBrickEdge) * 4);
      float* out = &padded[paddedIndex(0, y, z)];
      std::fill(out, out + kPaddedEdge, std::numeric_limits<float>::quiet_NaN());
      if (const std::int32_t b = neighbours[side]; b >= 0)
        std::copy_n(&nodes[std::size_t(b) * kBrickNodes + row], kBrickEdge, out);
      if (const std::int32_t b = neighbours[side + 1]; b >= 0)
        out[kBrickEdge] = nodes[std::size_t(b) * kBrickNodes + row];
    }
}

bool hasBothSigns(const Padded& value) {
  bool negative = false, positive = false;
  for (const float s : value) {
    negative |= s < 0;
    positive |= s >= 0;
  }
  return negative && positive;
}

// NaN is neither below 0 nor at least 0, so that an edge to an undefined node is never cut.
bool isCut(float a, float b) { return (a < 0 && b >= 0) || (b < 0 && a >= 0); }

std::uint8_t caseAt(const float* node) {
  unsigned bits = 0;
  bool isDefined = true;
  for (unsigned c = 0; c < 8; ++c) {
    const float s =
        node[(c & 1) * kPaddedStride[0] + ((c >> 1) & 1) * kPaddedStride[1] + (c >> 2) * kPaddedStride[2]];
    bits |= unsigned(s < 0) << c;
    isDefined &= s == s;
  }
  return std::uint8_t(isDefined ? bits : 0);
}

// What one task makes of its bricks.
struct Part {
  std::vector<glm::vec3> positions;
  std::vector<std::uint8_t> keep;
  std::vector<Triangle> triangles;
};

class Mesher {
 public:
  Mesher(const BrickField& field, const VertexTest& keep)
      : field_(field), keepTest_(keep), cuts_(field.bricks.size()), first_(field.bricks.size() + 1, 0) {}

  BrickMesh run(const Progress& progress) {
    const std::size_t tasks = (field_.bricks.size() + kBricksPerTask - 1) / kBricksPerTask;
    std::vector<Part> parts(tasks);
    forEachBrick(parts, progress.part(0, 0.5), [&](std::size_t brick, Part& part) { cutBrick(brick, part); });
    for (std::size_t b = 0; b + 1 < first_.size(); ++b) first_[b + 1] += first_[b];
    BrickMesh result;
    for (const Part& part : parts) {
      result.mesh.positions.insert(result.mesh.positions.end(), part.positions.begin(), part.positions.end());
      keep_.insert(keep_.end(), part.keep.begin(), part.keep.end());
    }
    require(result.mesh.positions.size() < 0xffffffffu, "The mesh is too fine: lower its resolution.");
    forEachBrick(parts, progress.part(0.5, 1),
                 [&](std::size_t brick, Part& part) { fillBrick(brick, part); });
    for (const Part& part : parts)
      result.mesh.triangles.insert(result.mesh.triangles.end(), part.triangles.begin(), part.triangles.end());
    result.firstVertex = std::move(first_);
    return result;
  }

 private:
  template <class F>
  void forEachBrick(std::vector<Part>& parts, const Progress& progress, F&& f) const {
    parallelFor(
        std::ptrdiff_t(parts.size()),
        [&](std::ptrdiff_t task) {
          const std::size_t first = std::size_t(task) * kBricksPerTask;
          const std::size_t last = std::min(first + kBricksPerTask, field_.bricks.size());
          for (std::size_t b = first; b < last; ++b) f(b, parts[std::size_t(task)]);
        },
        progress);
  }

  // Finds a brick's cut edges and cases, and makes its vertices.
  void cutBrick(std::size_t brick, Part& part) {
    BrickCuts& cuts = cuts_[brick];
    cuts.cubeCase.fill(0);
    Padded value, coverage;
    const Neighbours neighbours = upperNeighbours(field_, brick);
    loadPadded(field_.value, neighbours, value);
    if (!hasBothSigns(value)) return;
    loadPadded(field_.coverage, neighbours, coverage);
    std::uint8_t count = 0;
    for (std::size_t n = 0; n < kBrickNodes; ++n) {
      const glm::ivec3 node(int(n % 4), int(n / 4 % 4), int(n / 16));
      const std::size_t at = paddedIndex(node.x, node.y, node.z);
      cuts.cubeCase[n] = caseAt(&value[at]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t next = at + kPaddedStride[axis];
        const bool cut = isCut(value[at], value[next]);
        cuts.vertex[3 * n + axis] = cut ? count++ : kNoVertex;
        if (!cut) continue;
        const float t = value[at] / (value[at] - value[next]);
        glm::vec3 position(node);
        position[int(axis)] += t;
        addVertex(brick, field_.corner(brick) + field_.cell * position,
                  coverage[at] + t * (coverage[next] - coverage[at]), part);
      }
    }
    first_[brick + 1] = count;
  }

  void addVertex(std::size_t brick, const glm::vec3& position, float coverage, Part& part) const {
    part.positions.push_back(position);
    part.keep.push_back(keepTest_(brick, position, coverage));
  }

  // Makes the triangles of a brick's cells whose vertices may all stay.
  void fillBrick(std::size_t brick, Part& part) const {
    const BrickCuts& cuts = cuts_[brick];
    if (std::all_of(cuts.cubeCase.begin(), cuts.cubeCase.end(),
                    [](std::uint8_t c) { return c == 0 || c == 255; }))
      return;
    const Neighbours neighbours = upperNeighbours(field_, brick);
    for (std::size_t n = 0; n < kBrickNodes; ++n) {
      const CubeCase& cube = kCubeCases[cuts.cubeCase[n]];
      const glm::ivec3 node(int(n % 4), int(n / 4 % 4), int(n / 16));
      for (std::size_t t = 0; t < cube.count; ++t) {
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i)
          triangle[i] = vertexNumber(neighbours, node, cube.triangles[t][i]);
        if (keep_[triangle[0]] && keep_[triangle[1]] && keep_[triangle[2]])
          part.triangles.push_back(triangle);
      }
    }
  }

  // The number of the vertex on an edge of the cell at `node`.
  std::uint32_t vertexNumber(const Neighbours& neighbours, glm::ivec3 node, int edge) const {
    const int corner = edgeStart(edge);
    node += glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    const auto side = std::size_t(node.x / kBrickEdge + node.y / kBrickEdge * 2 + node.z / kBrickEdge * 4);
    const auto owner = std::size_t(neighbours[side]);
    const auto inner = std::size_t((node.z % kBrickEdge * kBrickEdge + node.y % kBrickEdge) * kBrickEdge +
                                   node.x % kBrickEdge);
    return first_[owner] + cuts_[owner].vertex[3 * inner + std::size_t(edgeAxis(edge))];
  }

  const BrickField& field_;
  const VertexTest& keepTest_;
  std::vector<BrickCuts> cuts_;
  std::vector<std::uint32_t> first_;  // first vertex of each brick
  std::vector<std::uint8_t> keep_;    // per vertex
};

}  // namespace

BrickMesh meshBricks(const BrickField& field, const VertexTest& keep, const Progress& progress) {
  return Mesher(field, keep).run(progress);
}

}  // namespace sonoskin
