#include "render/skin/blur_kernel.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {

BlurKernel makeBlurKernel(double spacing) {
  const int taps = int(3.5 / spacing);
  const auto gaussian = [&](int i) { return std::exp(-0.5 * i * i * spacing * spacing); };
  double moments[3] = {};  // of order 0, 2, 4
  for (int i = -taps; i <= taps; ++i)
    for (int k = 0; k < 3; ++k) moments[k] += gaussian(i) * std::pow(i * spacing, 2 * k);
  // a + b x^2 that makes moments 0 and 2 one.
  const double determinant = moments[0] * moments[2] - moments[1] * moments[1];
  const double a = (moments[2] - moments[1]) / determinant, b = (moments[0] - moments[1]) / determinant;
  BlurKernel kernel;
  for (int i = 0; i <= taps; ++i) {
    const double x = i * spacing;
    kernel.places.push_back(float(x));
    kernel.weights.push_back(float(gaussian(i) * (a + b * x * x)));
  }
  return kernel;
}

double blurSpacing(double sigma, double texel, double smoothed) {
  const double allowed = std::max(1.5 * texel, 2 * smoothed) / sigma;
  return 1 / std::ceil(std::clamp(1 / allowed, 1.0, 6.0));
}

}  // namespace sonoskin
