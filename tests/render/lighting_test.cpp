#include "render/lighting.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace sonoskin {
namespace {

Camera camera() { return lookAlong({0, 1, 0}, {0, 0, 1}, Box{{-1, -1, -1}, {1, 1, 1}}, 1); }

TEST(Lighting, AzimuthAndElevationAreSeenFromTheCamera) {
  const auto key = [](const char* words) { return parseLighting(words, camera()).key.direction; };
  const auto close = [](const glm::vec3& a, const glm::vec3& b) { return glm::distance(a, b) < 1e-6f; };
  EXPECT_TRUE(close(key("azimuth=0,elevation=0"), -camera().forward));
  EXPECT_TRUE(close(key("azimuth=90,elevation=0"), camera().right()));
  EXPECT_TRUE(close(key("elevation=90,azimuth=12"), camera().up));
}

TEST(Lighting, WhatIsNotSaidStaysAsInThePortrait) {
  const Lighting portrait = portraitLighting(camera());
  const Lighting same = parseLighting("strength=2", camera());
  EXPECT_LT(glm::distance(same.key.direction, portrait.key.direction), 1e-5f);
  EXPECT_FLOAT_EQ(same.key.colour.x, 2 * portrait.key.colour.x);
  EXPECT_EQ(same.fill.direction, portrait.fill.direction);
  EXPECT_EQ(parseLighting("portrait", camera()).key.direction, portrait.key.direction);
}

TEST(Lighting, RefusesOtherWords) {
  for (const char* words : {"bright", "azimuth", "azimuth=", "azimuth=x", "azimuth=nan", "strength=-1",
                            "strength=1e9", "azimuth=1;elevation=2", ",", "roll=3"})
    EXPECT_THROW(parseLighting(words, camera()), Error) << words;
}

}  // namespace
}  // namespace sonoskin
