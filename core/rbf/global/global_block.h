#pragma once

#include <span>
#include <vector>

#include "core/rbf/global/chebyshev_cube.h"
#include "core/rbf/global/global_rbf.h"

namespace sonoskin {

// GlobalBlock: a global function inside a cube: the share of the centres that are far from it, and the polynomial, by
// interpolation between a few nodes; that of the near ones by the direct sum. Coordinates are those of the unit frame.
//   cost       to make: centres times 216 kernels; a value: near centres + 40 operations
//   accuracy   1e-3 of a cell for cubes of 27 cells; 1e-2 for a gaussian through all points, whose weights are large:
//              tests/core/global_function_test.cpp
class GlobalBlock {
 public:
  GlobalBlock(const GlobalRbf::Parts& parts, const glm::dvec3& centre, double halfEdge);

  // values: S at corner + cell (x, y, z) for the nodes of a brick, mm; all inside the cube.
  void values(const glm::dvec3& corner, double cell, std::span<float, 64> result) const;

  // gradients: ∇S per unit of the frame.
  std::vector<glm::dvec3> gradients(const Sites& places) const;

  std::size_t nearCentres() const { return near_.size(); }

 private:
  glm::dvec3 centre_;
  double halfEdge_;
  RadialKernel kernel_;
  Sites near_;
  std::vector<double> nearWeights_;
  ChebyshevCube far_;
};

}  // namespace sonoskin
