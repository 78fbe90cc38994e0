#pragma once

#include <functional>
#include <vector>

namespace sonoskin {

// NelderMeadOptions: where a search ends.
//   step        edge of the first simplex
//   tolerance   of the values over the simplex, relative; evaluations: at most so many
struct NelderMeadOptions {
  double step = 0.3, tolerance = 1e-7;
  int evaluations = 1000;
};

// Minimum: a place and the value there.
struct Minimum {
  std::vector<double> place;
  double value = 0;
};

// findMinimum: a local minimum near the start, without derivatives.                       [Nelder, Mead 1965]
Minimum findMinimum(const std::function<double(const std::vector<double>&)>& function,
                    const std::vector<double>& start, const NelderMeadOptions& options = {});

}  // namespace sonoskin
