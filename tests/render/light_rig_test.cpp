#include "render/skin/light_rig.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

const HomeFrame kHome{};
const Box kBox{{-30, -40, -20}, {30, 40, 20}};

TEST(LightRig, AnglesAndDirectionsAreInverse) {
  for (const double azimuth : {-170.0, -38.0, 0.0, 95.0})
    for (const double elevation : {-80.0, 0.0, 38.0}) {
      LightOptions o;
      o.azimuth = azimuth;
      o.elevation = elevation;
      const glm::vec2 angles = lightAngles(lightPlace(o, kHome), kHome);
      EXPECT_NEAR(double(angles.x), azimuth, 1e-3);
      EXPECT_NEAR(double(angles.y), elevation, 1e-3);
    }
  LightOptions ahead;
  ahead.azimuth = ahead.elevation = 0;
  EXPECT_LT(glm::distance(lightPlace(ahead, kHome), kHome.back), 1e-6f);
}

TEST(LightRig, WarmLightIsRedAndAsBright) {
  LightOptions o;
  o.strength = 2;
  const auto colour = [&](double kelvin) {
    o.warmth = kelvin;
    return makeLightRig(o, kHome, kBox).lights[0].colour;
  };
  for (const double kelvin : {1800.0, 3200.0, 6500.0, 12000.0})
    EXPECT_NEAR(double(glm::dot(colour(kelvin), glm::vec3(0.2126f, 0.7152f, 0.0722f))), 2, 1e-4);
  EXPECT_LT(glm::distance(colour(6500), glm::vec3(2)), 1e-4f);
  EXPECT_GT(colour(3200).r, colour(5000).r);
  EXPECT_GT(colour(9000).b, colour(6500).b);
}

TEST(LightRig, ALampInsideStaysInTheBody) {
  LightOptions o;
  o.kind = LightKind::inside;
  o.distance = 500;
  const SkinLight lamp = makeLightRig(o, kHome, kBox).lights[0];
  EXPECT_LT(glm::distance(lamp.position, kBox.centre()), 0.51f * 0.5f * kBox.diagonal());
  EXPECT_FALSE(lamp.shadows);
}

// Order 1 of the harmonics is exact for a sky that changes with the cosine.
TEST(LightRig, SurroundIsBrighterAbove) {
  const LightRig rig = makeLightRig({}, kHome, kBox);
  const auto radiance = [&](const glm::vec3& d) {
    return 0.282095f * rig.environment[0] +
           0.488603f * (d.y * rig.environment[1] + d.z * rig.environment[2] + d.x * rig.environment[3]);
  };
  EXPECT_GT(radiance({0, 1, 0}).g, 2 * radiance({0, -1, 0}).g);
  EXPECT_GT(radiance({0, -1, 0}).g, 0);
}

}  // namespace
}  // namespace sonoskin
