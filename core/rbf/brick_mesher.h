#pragma once

#include <functional>

#include "core/rbf/brick_field.h"

namespace sonoskin {

// VertexTest: whether a vertex of a brick may stay, by its position and its coverage Σφ.
using VertexTest = std::function<bool(std::size_t brick, const glm::vec3& position, float coverage)>;

// BrickMesh: vertices numbered by the brick that owns them, unused ones included.
//   firstVertex   per brick, and the total at the end: brick b owns vertices firstVertex[b] .. firstVertex[b+1]-1
struct BrickMesh {
  Mesh mesh;
  std::vector<std::uint32_t> firstVertex;
};

// meshBricks: the surface where the samples cross 0; inside is < 0; a cell with an undefined node makes no triangle.
//   keep      triangles with a vertex that fails the test are left out
//   method    each brick owns the cut edges that start at its nodes: vertices are shared by number, without a hash
//   errors    Cancelled
BrickMesh meshBricks(const BrickField& field, const VertexTest& keep, const Progress& progress = {});

}  // namespace sonoskin
