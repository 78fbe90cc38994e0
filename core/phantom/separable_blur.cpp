#include "core/phantom/separable_blur.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {

std::vector<float> gaussTaps(float sigma, Keep keep) {
  if (sigma < 0.2f) return {1};
  const int reach = int(std::ceil(3 * sigma));
  std::vector<float> taps;
  double norm = 0;
  for (int i = -reach; i <= reach; ++i) {
    const double w = std::exp(-0.5 * i * i / (double(sigma) * sigma));
    norm += keep == Keep::mean ? w : w * w;
    taps.push_back(float(w));
  }
  const double scale = 1 / (keep == Keep::mean ? norm : std::sqrt(norm));
  for (float& w : taps) w = float(w * scale);
  return taps;
}

void blurRow(float* row, std::size_t count, const std::vector<float>& taps, std::vector<float>& scratch) {
  const std::size_t reach = taps.size() / 2;
  scratch.assign(count + 2 * reach, 0.f);
  std::copy(row, row + count, scratch.begin() + std::ptrdiff_t(reach));
  std::fill(row, row + count, 0.f);
  for (std::size_t t = 0; t < taps.size(); ++t) {
    const float w = taps[t];
    const float* in = scratch.data() + t;
    for (std::size_t i = 0; i < count; ++i) row[i] += w * in[i];
  }
}

void blurAcross(float* first, std::size_t rows, std::size_t stride, std::size_t width,
                const std::vector<float>& taps, std::vector<float>& scratch) {
  scratch.resize(std::max(scratch.size(), rows * width));
  for (std::size_t r = 0; r < rows; ++r) std::copy_n(first + r * stride, width, scratch.data() + r * width);
  const std::size_t reach = taps.size() / 2;
  for (std::size_t r = 0; r < rows; ++r) {
    float* out = first + r * stride;
    std::fill_n(out, width, 0.f);
    for (std::size_t t = 0; t < taps.size(); ++t) {
      if (r + t < reach || r + t - reach >= rows) continue;
      const float w = taps[t];
      const float* in = scratch.data() + (r + t - reach) * width;
      for (std::size_t i = 0; i < width; ++i) out[i] += w * in[i];
    }
  }
}

}  // namespace sonoskin
