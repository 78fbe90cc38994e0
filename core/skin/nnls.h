#pragma once

#include <span>
#include <vector>

namespace sonoskin {

// nonNegativeShares: the w >= 0 with sum 1 that minimise w' G w - 2 b' w.
//   method  active sets [Lawson, Hanson 1974]; ours: the sum is kept exactly by a Lagrange multiplier, where a
//           heavy row would only come close
//   input   gram   n x n, symmetric, positive semi-definite, diagonal > 0, n in 1 .. 8
//           rhs    b, n
//   cost    1 to 10 us
std::vector<double> nonNegativeShares(std::span<const double> gram, std::span<const double> rhs);

}  // namespace sonoskin
