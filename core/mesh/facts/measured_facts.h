#pragma once

#include <cstddef>

#include "core/mesh/mesh.h"

namespace sonoskin {

// MeasuredFacts: how much of a surface was measured.
//   measured     mm², every place by its share
//   filled       mm² of closed holes, where nothing was measured
//   holes        how many there are; what lies at a border of the surface is none
struct MeasuredFacts {
  double measured = 0, filled = 0;
  std::size_t holes = 0;
};

// measureFilled: all of it; a mesh that does not say was measured everywhere.
//   cost   1 million triangles: 0.2 s
MeasuredFacts measureFilled(const Mesh& mesh);

}  // namespace sonoskin
