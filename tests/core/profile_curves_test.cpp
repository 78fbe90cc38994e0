#include "core/skin/profile_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

// The area below a curve.
glm::dvec3 area(const ProfileCurves& curves, const std::vector<glm::dvec3>& curve) {
  glm::dvec3 sum(0);
  for (size_t i = 1; i < curve.size(); ++i)
    sum += (curve[i] + curve[i - 1]) / 2.0 * (curves.radius[i] - curves.radius[i - 1]);
  return sum;
}

TEST(ProfileCurves, AreaIsTheEnergyWithinTheReach) {
  for (ScatterProfile profile : {ScatterProfile::adult, ScatterProfile::newborn, ScatterProfile::custom})
    for (double width : {0.5, 1.0, 2.0}) {
      SkinOptions options;
      options.profile = profile;
      options.width = width;
      const ProfileCurves curves = makeProfileCurves(options);
      ASSERT_EQ(curves.target.size(), size_t(ProfileCurves::kSteps));
      const glm::dvec3 expected = energyWithin(curves.sum, ProfileCurves::kReach);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(area(curves, curves.fit)[c], expected[c], 0.003);
        EXPECT_NEAR(area(curves, curves.target)[c], expected[c], 0.006) << int(profile) << " " << width;
      }
    }
}

TEST(ProfileCurves, LiteratureIsItsOwnTarget) {
  const ProfileCurves curves = makeProfileCurves({});
  EXPECT_FALSE(curves.fitted);
  EXPECT_EQ(curves.target, curves.fit);
  EXPECT_EQ(curves.sum.variances, literatureSkin().variances);
}

TEST(ProfileCurves, MoreTermsAreCloser) {
  SkinOptions options;
  options.profile = ScatterProfile::custom;
  double before = 10;
  for (int k = 1; k <= 6; ++k) {
    options.gaussians = k;
    const ProfileCurves curves = makeProfileCurves(options);
    EXPECT_TRUE(curves.fitted);
    double most = 0;
    for (size_t i = 0; i < curves.fit.size(); ++i)
      most = std::max(most, std::abs(curves.fit[i].x - curves.target[i].x));
    EXPECT_LT(most, before);
    before = most;
  }
}

TEST(ProfileCurves, WidthZeroIsFlat) {
  SkinOptions options;
  options.profile = ScatterProfile::newborn;
  options.width = 0;
  const ProfileCurves curves = makeProfileCurves(options);
  for (size_t i = 0; i < curves.fit.size(); ++i) {
    EXPECT_EQ(curves.fit[i], glm::dvec3(0));
    EXPECT_EQ(curves.target[i], glm::dvec3(0));
  }
}

}  // namespace
}  // namespace sonoskin
