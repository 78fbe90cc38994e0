#pragma once

#include <cstddef>
#include <vector>

namespace sonoskin {

// gaussTaps: an odd number of weights of a Gaussian; {1} if sigma (standard deviation, samples) is below 0.2.
enum class Keep { mean, power };  // weights sum to 1, or their squares do (white noise keeps its variance)
std::vector<float> gaussTaps(float sigma, Keep keep);

// blurRow: convolves `count` samples in memory order; beyond the ends there is 0.
//   scratch  grows as needed
void blurRow(float* row, std::size_t count, const std::vector<float>& taps, std::vector<float>& scratch);

// blurAcross: convolves across rows: row r starts at first + r * stride and holds `width` samples.
void blurAcross(float* first, std::size_t rows, std::size_t stride, std::size_t width,
                const std::vector<float>& taps, std::vector<float>& scratch);

}  // namespace sonoskin
