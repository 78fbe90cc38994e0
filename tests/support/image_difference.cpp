#include "tests/support/image_difference.h"

#include <algorithm>
#include <cstdlib>

namespace sonoskin::test {

ImageDifference compareImages(const Image& actual, const Image& expected) {
  ImageDifference result;
  if (actual.width != expected.width || actual.height != expected.height || actual.rgba.empty())
    return result;
  result.picture = actual;
  double sum = 0;
  std::size_t bad = 0;
  for (std::size_t pixel = 0; pixel < actual.rgba.size(); pixel += 4) {
    int worst = 0;
    for (std::size_t c = pixel; c < pixel + 3; ++c) {
      const int difference = std::abs(int(actual.rgba[c]) - int(expected.rgba[c]));
      sum += difference;
      worst = std::max(worst, difference);
      result.picture.rgba[c] = std::uint8_t(std::min(255, 8 * difference));
    }
    bad += worst > kBadStep;
  }
  const double pixels = double(actual.rgba.size() / 4);
  result.meanError = sum / (3 * pixels);
  result.badShare = double(bad) / pixels;
  return result;
}

}  // namespace sonoskin::test
