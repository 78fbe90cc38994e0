#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/volume/sample.h"
#include "core/volume/volume.h"

namespace sonoskin {

// EdgeProfile: the mean of the greys along a surface's normals, each aligned at its steepest rise.
//   dark        mean 2 to 3.5 mm before the steepest place
//   bright      the greatest mean up to 4 mm behind it
//   rise        mm from 20 to 80 % between the two
//   steepestAt  grey at the steepest place of the mean
struct EdgeProfile {
  double dark = 0, bright = 0, rise = 0, steepestAt = 0;
};

// blurred: a Gaussian of 0.6 mm along each axis, by taps.
inline Volume<float> blurredVolume(Volume<float> v) {
  const glm::ivec3 dims = v.geometry.dims;
  const std::ptrdiff_t strides[] = {1, dims.x, std::ptrdiff_t(dims.x) * dims.y};
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = 0.6 / v.geometry.spacing[axis];
    const int reach = int(std::ceil(3 * sigma));
    std::vector<float> taps;
    float sum = 0;
    for (int t = -reach; t <= reach; ++t) taps.push_back(float(std::exp(-0.5 * t * t / (sigma * sigma))));
    for (const float t : taps) sum += t;
    const auto in = v.data;
    for (std::ptrdiff_t n = 0; n < std::ptrdiff_t(in.size()); ++n) {
      const int at = int(n / strides[axis] % dims[axis]);
      float mean = 0;
      for (int t = -reach; t <= reach; ++t)
        mean += taps[std::size_t(t + reach)] *
                in[std::size_t(n + (std::clamp(at + t, 0, dims[axis] - 1) - at) * strides[axis])];
      v.data[std::size_t(n)] = mean / sum;
    }
  }
  return v;
}

// edgeProfile: over the vertices of a truth that the probe sees and that face it by more than 0.5.
inline EdgeProfile edgeProfile(const Volume<float>& volume, const Mesh& truth) {
  constexpr double kStep = 0.1, kReach = 7, kSearch = 2.5;
  constexpr int kCount = int(2 * kReach / kStep) + 1, kHalf = 40;
  const Volume<float> smooth = blurredVolume(volume);
  std::vector<double> mean(2 * kHalf + 1, 0), profile(kCount);
  double count = 0;
  for (std::size_t v = 0; v < truth.positions.size(); ++v) {
    if (truth.visibility[v] < 0.5f || truth.normals[v].y > -0.5f) continue;
    for (int n = 0; n < kCount; ++n) {
      const glm::dvec3 p =
          glm::dvec3(truth.positions[v]) + glm::dvec3(truth.normals[v]) * (kReach - n * kStep);
      profile[std::size_t(n)] = double(sampleTrilinear(smooth, glm::vec3(smooth.geometry.toIndex(p))));
    }
    int best = 0;
    double steepest = -1;
    for (int n = int((kReach - kSearch) / kStep); n <= int((kReach + kSearch) / kStep); ++n)
      if (const double s = profile[std::size_t(n + 1)] - profile[std::size_t(n - 1)]; s > steepest)
        steepest = s, best = n;
    for (int n = -kHalf; n <= kHalf; ++n) mean[std::size_t(n + kHalf)] += profile[std::size_t(best + n)];
    count += 1;
  }
  for (double& m : mean) m /= count;
  EdgeProfile e;
  for (int n = kHalf - 35; n <= kHalf - 20; ++n) e.dark += mean[std::size_t(n)] / 16;
  const auto peak = std::max_element(mean.begin() + kHalf, mean.end());
  e.bright = *peak;
  const auto crossing = [&](double share) {
    const double level = e.dark + share * (e.bright - e.dark);
    auto at = peak;
    while (at != mean.begin() && *(at - 1) > level) --at;
    if (at == mean.begin()) return 0.0;
    return double(at - mean.begin()) - (*at - level) / (*at - *(at - 1));
  };
  e.rise = kStep * (crossing(0.8) - crossing(0.2));
  double steepest = -1;
  for (auto at = mean.begin() + 1; at < peak; ++at)
    if (*(at + 1) - *(at - 1) > steepest) steepest = *(at + 1) - *(at - 1), e.steepestAt = *at;
  return e;
}

}  // namespace sonoskin
