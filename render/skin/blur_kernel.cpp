#include "render/skin/blur_kernel.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {

BlurKernel makeBlurKernel(double spacing) {
  const int taps = int(std::lround(3 / spacing));
  std::vector<double> weights(std::size_t(taps) + 1);
  double sum = 0, variance = 0;
  for (int i = 0; i <= taps; ++i) {
    const double x = i * spacing, sides = i == 0 ? 1 : 2;
    weights[std::size_t(i)] = std::exp(-0.5 * x * x);
    sum += sides * weights[std::size_t(i)];
    variance += sides * weights[std::size_t(i)] * x * x;
  }
  BlurKernel kernel;
  for (int i = 0; i <= taps; ++i) {
    kernel.places.push_back(float(i * spacing / std::sqrt(variance / sum)));
    kernel.weights.push_back(float(weights[std::size_t(i)] / sum));
  }
  return kernel;
}

double blurSpacing(double sigma, double texel, double smoothed) {
  const double allowed = std::max(1.5 * texel, 2 * smoothed) / sigma;
  // Steps of 1 / n end at 3 exactly.
  return 1 / std::ceil(std::clamp(1 / allowed, 1.0, 8.0));
}

}  // namespace sonoskin
