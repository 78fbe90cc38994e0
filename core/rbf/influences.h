#pragma once

#include "core/base/progress.h"
#include "core/rbf/point_grid.h"

namespace sonoskin {

// influences: d_i, the share of the surface that each point stands for: small in dense regions, large in
// sparse ones.
//   positions   mm, in the grid's sorted order
//   confidence  c_i > 0, in the same order
//   spacing     h, mm: the unit of length of the result and the first radius searched
//   neighbours  K; a point is not its own neighbour
//   solves      d_i = c_i Σ_{k in kNN_K(i)} |p_k - p_i|² / h², at least 1e-4 c_i so that copies of a
//               point keep a weight                         [Ohtake et al. 2004; thesis 3.11 without c_i]
//   cost        O(N K); 113k points, K = 10: 0.1 s on one core
//   errors      Cancelled
std::vector<float> influences(const std::vector<glm::vec3>& positions, const std::vector<float>& confidence,
                              const PointGrid& grid, double spacing, int neighbours,
                              const Progress& progress = {});

}  // namespace sonoskin
