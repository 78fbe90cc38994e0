#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace sonoskin {

// Bricks of 4³ nodes of a lattice; node (x, y, z) of a brick is at index x + 4 y + 16 z, and at bit x + 4 y + 16 z of a
// NodeSet.
constexpr int kBrickEdge = 4;
constexpr std::size_t kBrickNodes = 64;
using NodeSet = std::uint64_t;

constexpr int brickNode(int x, int y, int z) { return x + kBrickEdge * (y + kBrickEdge * z); }
inline glm::ivec3 nodePlace(int node) { return {node % 4, node / 4 % 4, node / 16}; }

// Farthest that a node, or a vertex on an edge that starts at one, can be from the brick's centre.
constexpr float brickReach(float cell) { return 3.47f * cell; }

// kLayer[axis][i]: the nodes whose place along an axis is i.
constexpr std::array<std::array<NodeSet, kBrickEdge>, 3> kLayer = [] {
  std::array<std::array<NodeSet, kBrickEdge>, 3> layers{};
  for (int n = 0; n < int(kBrickNodes); ++n) {
    layers[0][std::size_t(n % 4)] |= NodeSet(1) << n;
    layers[1][std::size_t(n / 4 % 4)] |= NodeSet(1) << n;
    layers[2][std::size_t(n / 16)] |= NodeSet(1) << n;
  }
  return layers;
}();
constexpr std::array<int, 3> kNodeStride{1, 4, 16};

// shifted: bit n tells of the node one step further along the axis, which may belong to the next brick.
constexpr NodeSet shifted(NodeSet own, NodeSet next, int axis) {
  const int stride = kNodeStride[std::size_t(axis)];
  const auto& layer = kLayer[std::size_t(axis)];
  return ((own & ~layer[0]) >> stride) | ((next & layer[0]) << (3 * stride));
}

}  // namespace sonoskin
