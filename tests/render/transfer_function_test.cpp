#include "render/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/gl/read_pixels.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

const TransferFunction kRamp{{{0.2f, {0, 0, 0}, 0}, {0.4f, {1, 0.5f, 0}, 0}, {0.8f, {1, 1, 1}, 0.6f}}};

TEST(TransferFunction, IsLinearBetweenPointsAndConstantBeyond) {
  EXPECT_EQ(kRamp.at(0), glm::vec4(0, 0, 0, 0));
  EXPECT_NEAR(glm::length(kRamp.at(0.3f) - glm::vec4(0.5f, 0.25f, 0, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::length(kRamp.at(0.6f) - glm::vec4(1, 0.75f, 0.5f, 0.3f)), 0, 1e-6);
  EXPECT_EQ(kRamp.at(1), glm::vec4(1, 1, 1, 0.6f));
}

TEST(TransferFunction, ThresholdIsWhereTheOpacityStarts) {
  EXPECT_FLOAT_EQ(kRamp.threshold(), 0.4f);
  EXPECT_FLOAT_EQ((TransferFunction{{{0.3f, glm::vec3(1), 0.1f}}}).threshold(), 0);
  EXPECT_FLOAT_EQ((TransferFunction{{{0.3f, glm::vec3(1), 0}, {0.7f, glm::vec3(1), 0}}}).threshold(), 1);
}

TEST(TransferFunction, AmberRisesInOpacityAndLightnessAroundEveryIsoValue) {
  for (const float iso : {0.05f, 0.3f, 0.7f, 0.95f}) {
    const TransferFunction amber = amberTransfer(iso);
    EXPECT_EQ(amber.at(0.5f * iso).a, 0);
    for (float v = 0; v < 1; v += 0.02f) {
      EXPECT_LE(amber.at(v).a, amber.at(v + 0.02f).a + 1e-6f);
      EXPECT_LE(amber.at(v).g, amber.at(v + 0.02f).g + 1e-6f);
      EXPECT_FLOAT_EQ(greyTransfer(iso).at(v).a, amber.at(v).a);
    }
  }
}

class TransferTextureTest : public GlTest {};

TEST_F(TransferTextureTest, HoldsTheFunction) {
  const auto texels = gl::readFloats(makeTransferTexture(kRamp), 4);
  const auto thin = gl::readFloats(makeTransferTexture(kRamp, 0.5f), 4);
  const std::size_t count = texels.size() / 4;
  ASSERT_EQ(count, 1024u);
  ASSERT_EQ(thin.size(), texels.size());
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec4 look = kRamp.at(float(i) / float(count - 1));
    EXPECT_FLOAT_EQ(texels[4 * i], look.r);
    EXPECT_NEAR(texels[4 * i + 3], look.a, 1e-6);
    // Two layers of half the thickness are one.
    EXPECT_NEAR(1 - std::pow(1 - thin[4 * i + 3], 2), look.a, 1e-6);
  }
}

}  // namespace
}  // namespace sonoskin
