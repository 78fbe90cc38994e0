#pragma once

#include <array>
#include <cstdint>

namespace sonoskin {

// The cube of marching cubes.
//   corner c   at ((c & 1), (c >> 1) & 1, (c >> 2) & 1)
//   edge e     parallel to axis e / 4; it starts at corner edgeStart(e) and ends one step along that axis
//   case       bit c is set where corner c is inside
constexpr int kCubeEdges = 12;
constexpr int edgeAxis(int edge) { return edge / 4; }
constexpr int edgeStart(int edge) {
  constexpr std::array<int, kCubeEdges> starts{0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
  return starts[static_cast<std::size_t>(edge)];
}
constexpr int edgeEnd(int edge) { return edgeStart(edge) | (1 << edgeAxis(edge)); }

// CubeCase: the triangles of one of the 256 sign patterns, as cube edges; counter-clockwise seen from
// outside.
struct CubeCase {
  static constexpr int kMaxTriangles = 5;
  std::uint8_t count = 0;
  std::array<std::array<std::uint8_t, 3>, kMaxTriangles> triangles{};
};

// kCubeCases: made at compile time from one rule instead of being copied from paper to paper.
//   rule     on each face every run of neighbouring inside corners is cut off by one segment, so that inside
//            corners are always separated; both cells at a face see the same segments, hence no cracks.
//            Segments chain to loops of 3 to 7 edges. A loop is split by chords none of which lies in a face,
//            hence no edge of the mesh is used by more than two triangles.      [Lorensen, Cline 1987; the
//            rule is ours]
//   size     820 triangles in all
extern const std::array<CubeCase, 256> kCubeCases;

}  // namespace sonoskin
