#pragma once

#include "core/mesh/mesh.h"
#include "tests/benchmarks/accuracy/faces_truth.h"

namespace sonoskin::accuracy {

// Spurs: parts of a mesh that are no skin.
//   area      mm², of all of them
//   largest   a place in the middle of the one with the largest area
struct Spurs {
  std::size_t count = 0;
  double area = 0;
  glm::vec3 largest{0};
};

// findSpurs: the parts, connected by common vertices, of those triangles all of whose vertices are farther than 1.5 mm
// from the truth, seen or not; of these parts, the ones with a vertex farther than 2 mm. Two bounds, so that a part that
// stands near the bound is one spur or none, and not many.
Spurs findSpurs(const Mesh& mesh, const FaceTruth& truth);

}  // namespace sonoskin::accuracy
