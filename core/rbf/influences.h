#pragma once

#include <vector>

#include "core/base/progress.h"

namespace sonoskin {

struct SortedPoints;

// influences: d_i, the share of the surface that each point stands for: small in dense regions, large in
// sparse ones.
//   points      their grid, coordinates and spacing h, which is the unit of length of the result
//   confidence  c_i > 0, in the sorted order
//   neighbours  K; a point is not its own neighbour
//   solves      d_i = c_i Σ_{k in kNN_K(i)} |p_k - p_i|² / h², at least 1e-4 c_i so that copies of a
//               point keep a weight                         [Ohtake et al. 2004; thesis 3.11 without c_i]
//   cost        O(N K); 113k points, K = 10: 0.05 s on one core
//   errors      Cancelled
std::vector<float> influences(const SortedPoints& points, const std::vector<float>& confidence,
                              int neighbours, const Progress& progress = {});

}  // namespace sonoskin
