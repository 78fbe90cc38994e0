#include "core/mesh/half_edges.h"

#include <algorithm>
#include <array>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

struct Side {
  std::uint32_t high, halfEdge;  // its larger vertex
};

// The sides of all triangles, sorted into bins by their smaller vertex.
struct SideBins {
  std::vector<std::uint32_t> start;  // of each vertex' bin, and the end
  std::vector<Side> sides;
};

SideBins binSides(const std::vector<Triangle>& triangles, std::size_t vertices) {
  SideBins bins{std::vector<std::uint32_t>(vertices + 2, 0), std::vector<Side>(3 * triangles.size())};
  const auto forEachSide = [&](const auto& f) {
    for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h) {
      const std::uint32_t a = originOf(triangles, h), b = originOf(triangles, nextHalfEdge(h));
      f(h, std::min(a, b), std::max(a, b));
    }
  };
  forEachSide([&](std::uint32_t, std::uint32_t low, std::uint32_t) { ++bins.start[low + 2]; });
  for (std::size_t v = 2; v < bins.start.size(); ++v) bins.start[v] += bins.start[v - 1];
  forEachSide([&](std::uint32_t h, std::uint32_t low, std::uint32_t high) {
    bins.sides[bins.start[low + 1]++] = {high, h};
  });
  return bins;
}

}  // namespace

std::vector<std::uint32_t> oppositeHalfEdges(const std::vector<Triangle>& triangles, std::size_t vertices) {
  std::vector<std::uint32_t> opposite(3 * triangles.size(), kNoHalfEdge);
  SideBins bins = binSides(triangles, vertices);
  constexpr std::size_t kPerTask = 1 << 14;
  parallelItems(vertices, kPerTask, [&](std::size_t v) {
    const auto begin = bins.sides.begin() + bins.start[v], end = bins.sides.begin() + bins.start[v + 1];
    std::sort(begin, end, [](const Side& a, const Side& b) {
      return a.high != b.high ? a.high < b.high : a.halfEdge < b.halfEdge;
    });
    for (auto first = begin; first < end;) {
      auto last = first;
      while (last < end && last->high == first->high) ++last;
      const std::uint32_t a = first->halfEdge, b = (last - 1)->halfEdge;
      if (last - first == 2 && originOf(triangles, a) != originOf(triangles, b)) {
        opposite[a] = b;
        opposite[b] = a;
      }
      first = last;
    }
  });
  return opposite;
}

std::vector<std::vector<std::uint32_t>> borderLoops(const std::vector<Triangle>& triangles,
                                                    const std::vector<std::uint32_t>& opposite) {
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<bool> seen(opposite.size(), false);
  for (std::uint32_t start = 0; start < 3 * triangles.size(); ++start) {
    if (opposite[start] != kNoHalfEdge || seen[start]) continue;
    loops.emplace_back();
    for (std::uint32_t h = start; !seen[h];) {
      seen[h] = true;
      loops.back().push_back(h);
      h = nextHalfEdge(h);  // then around its vertex to the next border
      while (opposite[h] != kNoHalfEdge) h = nextHalfEdge(opposite[h]);
    }
  }
  return loops;
}

void compactVertices(Mesh& mesh) {
  std::vector<std::uint32_t> number(mesh.positions.size(), kNoHalfEdge);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoHalfEdge) continue;
    mesh.positions[kept] = mesh.positions[v];
    if (!mesh.normals.empty()) mesh.normals[kept] = mesh.normals[v];
    if (!mesh.visibility.empty()) mesh.visibility[kept] = mesh.visibility[v];
    if (!mesh.labels.empty()) mesh.labels[kept] = mesh.labels[v];
    if (!mesh.measured.empty()) mesh.measured[kept] = mesh.measured[v];
    number[v] = kept++;
  }
  mesh.positions.resize(kept);
  if (!mesh.normals.empty()) mesh.normals.resize(kept);
  if (!mesh.visibility.empty()) mesh.visibility.resize(kept);
  if (!mesh.labels.empty()) mesh.labels.resize(kept);
  if (!mesh.measured.empty()) mesh.measured.resize(kept);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

std::vector<std::uint32_t> splitFans(Mesh& mesh) {
  std::vector<std::uint32_t> opposite = oppositeHalfEdges(mesh.triangles, mesh.positions.size());
  const std::size_t before = mesh.positions.size();
  std::vector<bool> isTaken(before, false), isDone(3 * mesh.triangles.size(), false);
  for (std::uint32_t corner = 0; corner < isDone.size(); ++corner) {
    if (isDone[corner]) continue;
    // To the first triangle of the fan, or once around it.
    std::uint32_t first = corner;
    while (opposite[first] != kNoHalfEdge) {
      first = nextHalfEdge(opposite[first]);
      if (first == corner) break;
    }
    std::uint32_t vertex = originOf(mesh.triangles, first);
    if (isTaken[vertex]) {
      mesh.positions.push_back(glm::vec3(mesh.positions[vertex]));
      if (!mesh.normals.empty()) mesh.normals.push_back(glm::vec3(mesh.normals[vertex]));
      if (!mesh.visibility.empty()) mesh.visibility.push_back(float(mesh.visibility[vertex]));
      if (!mesh.labels.empty()) mesh.labels.push_back(std::uint8_t(mesh.labels[vertex]));
      if (!mesh.measured.empty()) mesh.measured.push_back(float(mesh.measured[vertex]));
      vertex = std::uint32_t(mesh.positions.size() - 1);
    } else {
      isTaken[vertex] = true;
    }
    for (std::uint32_t h = first; !isDone[h];) {
      isDone[h] = true;
      mesh.triangles[h / 3][h % 3] = vertex;
      const std::uint32_t incoming = nextHalfEdge(nextHalfEdge(h));
      if (opposite[incoming] == kNoHalfEdge) break;
      h = opposite[incoming];
    }
  }
  if (mesh.positions.size() == before) return opposite;
  return oppositeHalfEdges(mesh.triangles, mesh.positions.size());
}

}  // namespace sonoskin
