#pragma once

#include <algorithm>
#include <cmath>

namespace sonoskin {

// fractionOfResidual: how far an iteration has come from the residual `first` down to `goal`, on the logarithmic
// scale on which it falls evenly; in [0, 1].
inline double fractionOfResidual(double residual, double first, double goal) {
  if (residual <= goal || first <= goal) return 1;
  return std::clamp(std::log(first / residual) / std::log(first / goal), 0.0, 1.0);
}

}  // namespace sonoskin
