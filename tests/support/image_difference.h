#pragma once

#include "core/io/image.h"

namespace sonoskin::test {

// ImageDifference: how far two pictures of the same size are apart.
//   meanError  mean absolute difference of all colour channels, in 1/255
//   badShare   share of pixels with a channel that is off by more than kBadStep
//   picture    differences, eight times as strong
struct ImageDifference {
  double meanError = 255, badShare = 1;
  Image picture;
};

inline constexpr int kBadStep = 24;  // of 255; what an eye sees side by side

// compareImages: the largest difference there is (see above) where the sizes differ.
ImageDifference compareImages(const Image& actual, const Image& expected);

}  // namespace sonoskin::test
