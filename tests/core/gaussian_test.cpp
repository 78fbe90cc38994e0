#include "core/volume/gaussian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

TEST(Gaussian, KernelSumsToOneAndHasItsWidth) {
  const auto kernel = gaussianKernel(1.5);
  EXPECT_NEAR(std::accumulate(kernel.begin(), kernel.end(), 0.0), 1, 1e-6);
  double variance = 0;
  for (int m = 0; m < int(kernel.size()); ++m)
    variance += double(kernel[std::size_t(m)]) * std::pow(m - int(kernel.size()) / 2, 2);
  EXPECT_NEAR(variance, 1.5 * 1.5, 0.06);  // cut at 3 sigma
  EXPECT_EQ(gaussianKernel(0).size(), 1u);
}

TEST(Gaussian, KeepsConstantsUpToTheBorder) {
  for (const float v : gaussianBlur(Volume<float>(test::grid({9, 7, 5}), 0.6f), 2).data)
    EXPECT_NEAR(v, 0.6, 1e-6);
}

// An impulse becomes the product of three kernels, narrower in voxels along the coarse axis.
TEST(Gaussian, SpreadsAnImpulseByMillimetres) {
  Volume<float> impulse(test::grid({21, 21, 21}, {0.3, 0.3, 0.9}));
  impulse.at(10, 10, 10) = 1;
  const auto blurred = gaussianBlur(impulse, 1.5);
  const auto fine = gaussianKernel(1.5), coarse = gaussianKernel(0.5);
  const auto at = [](const std::vector<float>& k, int m) {
    return double(k[std::size_t(int(k.size()) / 2 + m)]);
  };
  for (const glm::ivec3 d : {glm::ivec3(0), glm::ivec3(2, -3, 1), glm::ivec3(-4, 1, -2)})
    EXPECT_NEAR(blurred.at(10 + d.x, 10 + d.y, 10 + d.z), at(fine, d.x) * at(fine, d.y) * at(coarse, d.z),
                1e-7);
}

TEST(Gaussian, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(gaussianBlur(Volume<float>(test::grid({9, 9, 9})), 1, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
