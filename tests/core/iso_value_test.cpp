#include "core/classification/iso_value.h"

#include <gtest/gtest.h>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

TEST(IsoValue, LiesBetweenFluidAndTissue) {
  const auto volume = test::speckledSphere(test::grid({48, 48, 48}), glm::dvec3(24), 15, 0.1);  // 0.1 and 0.8
  EXPECT_NEAR(proposeIsoValue(volume, {}), 0.1 + 0.38 * 0.7, 0.03);
}

TEST(IsoValue, DoesNotCountWhatLiesOutsideTheView) {
  const auto volume = test::fill(test::grid({60, 20, 20}), [](glm::dvec3 p) {
    return p.x < 30 ? 0.0 : p.x < 45 ? 0.4 : 0.8;  // a black margin beside fluid and tissue
  });
  const FieldOfView view{{glm::vec4(-1, 0, 0, 29.5)}, {}};
  EXPECT_NEAR(proposeIsoValue(volume, view), 0.4 + 0.38 * 0.4, 0.01);
}

TEST(IsoValue, OfAnEmptyVolumeIsInRange) {
  const float iso = proposeIsoValue(Volume<float>(test::grid({8, 8, 8})), {});
  EXPECT_GE(iso, 0.02f);
  EXPECT_LE(iso, 0.98f);
}

}  // namespace
}  // namespace sonoskin
