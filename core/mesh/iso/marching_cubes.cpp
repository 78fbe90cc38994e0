#include "core/mesh/iso/marching_cubes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/mesh/iso/marching_cubes_table.h"

namespace sonoskin {
namespace {

constexpr std::size_t kLayersPerTask = 8;

enum NodeState : std::uint8_t { outside = 0, inside = 1, undefined = 2 };

// The mesh owns one vertex per cut edge of the grid. An edge belongs to the node where it starts, so a slice
// of nodes owns a consecutive run of vertices, and two neighbouring slices know all vertices of the cells
// between.
class SlicedGrid {
 public:
  SlicedGrid(const Volume<float>& field, float level) : field_(field), level_(level) {
    state_.resize(field.data.size());
  }
  const glm::ivec3& dims() const { return field_.geometry.dims; }

  void classifySlice(int k) {
    const std::size_t from = field_.geometry.index(0, 0, k), to = field_.geometry.index(0, 0, k + 1);
    for (std::size_t n = from; n < to; ++n) {
      const float value = field_.data[n];
      state_[n] = std::isfinite(value) ? std::uint8_t(value < level_) : std::uint8_t(undefined);
    }
  }

  // The case of a cell, 0 if one of its nodes is undefined.
  unsigned cellCase(int i, int j, int k) const {
    unsigned bits = 0, seen = 0;
    for (unsigned c = 0; c < 8; ++c) {
      const unsigned state =
          state_[field_.geometry.index(i + int(c & 1), j + int((c >> 1) & 1), k + int(c >> 2))];
      bits |= (state & 1u) << c;
      seen |= state;
    }
    return seen & undefined ? 0 : bits;
  }

  // Calls f(i, j, edge axis) for the cut edges that start in slice k and that some cell uses, in order.
  template <class F>
  void forEachVertex(int k, F&& f) const {
    const glm::ivec3 d = dims();
    const std::size_t stride[3] = {1, std::size_t(d.x), std::size_t(d.x) * std::size_t(d.y)};
    for (int j = 0; j < d.y; ++j) {
      for (int i = 0; i < d.x; ++i) {
        if (isUniformRun(i, j, k)) {
          i += kRun - 2;
          continue;
        }
        const std::size_t n = field_.geometry.index(i, j, k);
        const glm::ivec3 node(i, j, k);
        for (int axis = 0; axis < 3; ++axis)
          if (node[axis] + 1 < d[axis] && (state_[n] ^ state_[n + stride[axis]]) == 1 && isUsed(node, axis))
            f(i, j, axis);
      }
    }
  }

  // Calls f(i, j, case) for the cells between slices k and k+1 that make triangles, in order.
  template <class F>
  void forEachCell(int k, F&& f) const {
    for (int j = 0; j + 1 < dims().y; ++j)
      for (int i = 0; i + 1 < dims().x; ++i) {
        if (isUniformRun(i, j, k)) {
          i += kRun - 2;
          continue;
        }
        if (const unsigned c = cellCase(i, j, k); c != 0 && c != 255) f(i, j, c);
      }
  }

  glm::vec3 vertex(int i, int j, int k, int axis) const {
    glm::ivec3 next(i, j, k);
    ++next[axis];
    const double a = double(field_.at(i, j, k)) - level_,
                 b = double(field_.at(next.x, next.y, next.z)) - level_;
    glm::dvec3 position(i, j, k);
    position[axis] += a / (a - b);
    return glm::vec3(field_.geometry.toWorld(position));
  }

 private:
  // Nodes whose states fit one machine word: most of a volume is far from the surface and is passed run by run.
  static constexpr int kRun = 8;

  // Whether the kRun nodes from (i, j, k) and their neighbours in j and k are all inside or all outside, so that
  // the first kRun - 1 of them start neither a cut edge nor a cell that holds surface.
  bool isUniformRun(int i, int j, int k) const {
    if (i + kRun > dims().x || j + 1 >= dims().y || k + 1 >= dims().z) return false;
    const auto states = [&](int row, int slice) {
      std::uint64_t word;
      std::memcpy(&word, &state_[field_.geometry.index(i, row, slice)], sizeof word);
      return word;
    };
    const std::uint64_t first = states(j, k);
    if (first != 0 && first != 0x0101010101010101u) return false;
    return states(j + 1, k) == first && states(j, k + 1) == first && states(j + 1, k + 1) == first;
  }

  // Whether one of the up to four cells around a cut edge is defined.
  bool isUsed(const glm::ivec3& node, int axis) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int quarter = 0; quarter < 4; ++quarter) {
      glm::ivec3 cell = node;
      cell[u] -= quarter & 1;
      cell[v] -= quarter >> 1;
      if (cell[u] < 0 || cell[v] < 0 || cell[u] + 1 >= dims()[u] || cell[v] + 1 >= dims()[v]) continue;
      if (cellCase(cell.x, cell.y, cell.z) != 0) return true;
    }
    return false;
  }

  const Volume<float>& field_;
  float level_;
  std::vector<std::uint8_t> state_;
};

// The vertex numbers of one slice of nodes; defined at used cut edges only.
using SliceNumbers = std::vector<std::array<std::uint32_t, 3>>;

// Where the vertices of each slice and the triangles of each layer start in the mesh, and how many there are.
struct Offsets {
  std::vector<std::size_t> vertices, triangles;
};

Offsets countAll(const SlicedGrid& grid, const Progress& progress) {
  const int slices = grid.dims().z;
  Offsets offsets{std::vector<std::size_t>(std::size_t(slices) + 1),
                  std::vector<std::size_t>(std::size_t(slices) + 1)};
  parallelFor(
      slices,
      [&](std::ptrdiff_t k) {
        std::size_t vertices = 0, triangles = 0;
        grid.forEachVertex(int(k), [&](int, int, int) { ++vertices; });
        if (k + 1 < slices)
          grid.forEachCell(int(k), [&](int, int, unsigned c) { triangles += kCubeCases[c].count; });
        offsets.vertices[std::size_t(k) + 1] = vertices;
        offsets.triangles[std::size_t(k) + 1] = triangles;
      },
      progress);
  for (std::size_t k = 0; k < std::size_t(slices); ++k) {
    offsets.vertices[k + 1] += offsets.vertices[k];
    offsets.triangles[k + 1] += offsets.triangles[k];
  }
  return offsets;
}

void numberSlice(const SlicedGrid& grid, int k, std::size_t first, SliceNumbers& numbers) {
  numbers.resize(std::size_t(grid.dims().x) * std::size_t(grid.dims().y));
  auto next = std::uint32_t(first);
  grid.forEachVertex(k, [&](int i, int j, int axis) {
    numbers[std::size_t(j) * std::size_t(grid.dims().x) + std::size_t(i)][std::size_t(axis)] = next++;
  });
}

void writeVertices(const SlicedGrid& grid, int k, std::size_t first, Mesh& mesh) {
  grid.forEachVertex(k,
                     [&](int i, int j, int axis) { mesh.positions[first++] = grid.vertex(i, j, k, axis); });
}

// The triangles between two numbered slices.
void writeTriangles(const SlicedGrid& grid, int k, const SliceNumbers& below, const SliceNumbers& above,
                    Triangle* out) {
  const auto width = std::size_t(grid.dims().x);
  grid.forEachCell(k, [&](int i, int j, unsigned c) {
    const std::size_t node = std::size_t(j) * width + std::size_t(i);
    const auto number = [&](int edge) {
      const auto start = unsigned(edgeStart(edge));
      const SliceNumbers& slice = start & 4u ? above : below;
      return slice[node + (start & 1u) + (start & 2u ? width : 0)][std::size_t(edgeAxis(edge))];
    };
    for (int t = 0; t < kCubeCases[c].count; ++t) {
      const auto& edges = kCubeCases[c].triangles[std::size_t(t)];
      *out++ = {number(edges[0]), number(edges[1]), number(edges[2])};
    }
  });
}

void writeMesh(const SlicedGrid& grid, const Offsets& offsets, Mesh& mesh, const Progress& progress) {
  const int slices = grid.dims().z;
  parallelBlocks(
      std::size_t(slices), kLayersPerTask,
      [&](std::size_t first, std::size_t end) {
        SliceNumbers below, above;
        numberSlice(grid, int(first), offsets.vertices[first], below);
        for (int k = int(first); k < int(end); ++k) {
          writeVertices(grid, k, offsets.vertices[std::size_t(k)], mesh);
          if (k + 1 == slices) break;
          numberSlice(grid, k + 1, offsets.vertices[std::size_t(k) + 1], above);
          writeTriangles(grid, k, below, above, mesh.triangles.data() + offsets.triangles[std::size_t(k)]);
          std::swap(below, above);
        }
      },
      progress);
}

}  // namespace

Mesh marchingCubes(const Volume<float>& field, float level, const Progress& progress) {
  Mesh mesh;
  const glm::ivec3 dims = field.geometry.dims;
  if (dims.x < 2 || dims.y < 2 || dims.z < 2) return mesh;
  SlicedGrid grid(field, level);
  parallelFor(
      dims.z, [&](std::ptrdiff_t k) { grid.classifySlice(int(k)); }, progress.part(0, 0.1));
  const Offsets offsets = countAll(grid, progress.part(0.1, 0.4));
  require(offsets.vertices.back() < 0xffffffffu,
          "The surface has more than 4 billion vertices; use a smaller volume.");
  mesh.positions.resize(offsets.vertices.back());
  mesh.triangles.resize(offsets.triangles.back());
  writeMesh(grid, offsets, mesh, progress.part(0.4, 1));
  if (field.geometry.mirrors())
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace sonoskin
