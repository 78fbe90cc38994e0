#include "core/phantom/fetal_head.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace sonoskin {
namespace {

using glm::vec3;

class Places {
 public:
  // Around head and neck, 1.2 times as large as the largest head.
  vec3 next() {
    const vec3 u(uniform_(engine_), uniform_(engine_), uniform_(engine_));
    return vec3(55, 70, 62) * u - vec3(0, 6, 0);
  }
  vec3 direction() {
    const vec3 u(uniform_(engine_), uniform_(engine_), uniform_(engine_));
    return u;
  }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<float> uniform_{-1, 1};
};

double slope(const vec3& p, const HeadShape& shape) {
  constexpr float kStep = 0.02f;
  glm::dvec3 g;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 h(0);
    h[axis] = kStep;
    g[axis] = double(headSkin(p + h, shape) - headSkin(p - h, shape)) / (2 * kStep);
  }
  return glm::length(g);
}

// Every trait at its end, up in one head and down in the other.
HeadShape extreme(float deviations) {
  HeadShape shape;
  for (const HeadTrait& trait : headTraits()) shape.*trait.number += deviations * trait.spread;
  return shape;
}

std::vector<HeadShape> heads() {
  std::vector<HeadShape> all{extreme(-2), extreme(2)};
  for (int seed = 0; seed < 8; ++seed) all.push_back(headShape(seed));
  return all;
}

TEST(FetalHead, TheFirstIsTheOneItAlwaysWas) {
  struct Known {
    vec3 p;
    float skin, bone;
  };
  const Known known[] = {
      {{0, -13, 50}, 4.802261f, 15.124516f},   {{3, -17, 42}, 0.743096f, 12.010196f},
      {{-14.5f, 0, 40}, 3.665072f, 7.704562f}, {{14.5f, -3, 35}, 0.222803f, 5.039619f},
      {{5, -24, 40}, -0.437776f, 12.382893f},  {{-9, -28, 36}, -0.400640f, 11.490453f},
      {{2, -20, 38}, -1.841461f, 8.892539f},   {{-39, 3, -8}, -1.236087f, 7.076096f},
      {{8, -42, 24}, 1.316437f, 13.136813f},   {{0, 50, 0}, 1.076839f, 5.065613f},
      {{12, 8, 40}, -0.181333f, 4.058441f},    {{-18, -18, 30}, -4.008065f, 7.653086f},
  };
  for (const Known& k : known) {
    EXPECT_NEAR(headSkin(k.p), k.skin, 1e-5f);
    EXPECT_NEAR(headBone(k.p), k.bone, 1e-5f);
    EXPECT_EQ(headSkin(k.p), headSkin(k.p, headShape(0)));
    EXPECT_EQ(headBone(k.p), headBone(k.p, headShape(0)));
  }
}

TEST(FetalHead, EveryHeadIsADistanceNearItsSkin) {
  for (const HeadShape& shape : heads()) {
    Places places;
    std::vector<double> atSkin;
    int steep = 0, near = 0;
    for (int n = 0; n < 60000; ++n) {
      const vec3 p = places.next();
      const float d = headSkin(p, shape);
      if (std::abs(d) > 3) continue;
      const double s = slope(p, shape);
      ++near;
      steep += s > 1.25;
      if (std::abs(d) < 0.3f) atSkin.push_back(s);
    }
    ASSERT_GT(near, 3000);
    EXPECT_LE(steep, near / 1000 + 1);
    std::sort(atSkin.begin(), atSkin.end());
    EXPECT_NEAR(atSkin[atSkin.size() / 2], 1, 0.02);
    EXPECT_GT(atSkin[atSkin.size() / 12], 0.8);
    EXPECT_LT(atSkin[atSkin.size() - 1 - atSkin.size() / 200], 1.2);
  }
}

TEST(FetalHead, NoHeadHasJumps) {
  for (const HeadShape& shape : heads()) {
    Places places;
    int near = 0;
    for (int n = 0; n < 60000; ++n) {
      const vec3 p = places.next(), q = p + 0.001f * places.direction();
      const float d = headSkin(p, shape);
      if (d > -4 && d < 8) {
        ++near;
        ASSERT_LT(std::abs(headSkin(q, shape) - d), 0.006) << p.x << ' ' << p.y << ' ' << p.z;
      }
    }
    EXPECT_GT(near, 5000);
  }
}

TEST(FetalHead, BonesLieUnderEverySkin) {
  for (const HeadShape& shape : heads()) {
    Places places;
    int inBone = 0;
    for (int n = 0; n < 40000; ++n) {
      const vec3 p = places.next();
      if (headBone(p, shape) > 0) continue;
      ++inBone;
      ASSERT_LT(headSkin(p, shape), -0.5f * shape.size) << p.x << ' ' << p.y << ' ' << p.z;
    }
    EXPECT_GT(inBone, 200);
  }
}

TEST(FetalHead, ItsSizeScalesEverything) {
  HeadShape small = headShape(3), large = small;
  small.size = 0.8f;
  large.size = 1.6f;
  Places places;
  for (int n = 0; n < 1000; ++n) {
    const vec3 p = places.next();
    EXPECT_NEAR(headSkin(2.f * p, large), 2 * headSkin(p, small), 1e-4f);
  }
}

TEST(FetalHead, ItsPlacesLieOnTheSkinOfEveryHead) {
  for (const HeadShape& shape : heads()) {
    const HeadPlaces f = headPlaces(shape);
    for (const vec3& p : {f.rightEye, f.leftEye, f.noseTip, f.mouthRight, f.mouthLeft, f.chin})
      EXPECT_NEAR(headSkin(p, shape), 0, 0.05);
    EXPECT_NEAR((f.leftEye - f.rightEye).x / shape.size, 28.8 * shape.faceWidth * shape.eyeDistance, 0.1);
    EXPECT_NEAR((f.mouthLeft - f.mouthRight).x / shape.size, 22 * shape.faceWidth * shape.mouthWidth, 0.1);
    EXPECT_GT(f.noseTip.z, f.leftEye.z + 5 * shape.size);
    EXPECT_GT(f.rightEye.y, f.noseTip.y);
    EXPECT_GT(f.noseTip.y, f.mouthLeft.y + 5 * shape.size);
    EXPECT_GT(f.mouthRight.y, f.chin.y + 3 * shape.size);
  }
}

// A place of the face really is that part: the nose's tip stands foremost, the eyes lie behind the brow's line.
TEST(FetalHead, TheNoseTipIsForemostInEveryHead) {
  for (int seed = 0; seed < 8; ++seed) {
    const HeadShape shape = headShape(seed);
    const vec3 tip = headPlaces(shape).noseTip;
    for (const vec3 aside : {vec3(7, 0, 0), vec3(-7, 0, 0), vec3(0, 8, 0), vec3(0, -7, 0)})
      EXPECT_GT(headSkin(tip + shape.size * aside, shape), 0.8f * shape.size) << seed;
  }
}

TEST(HeadShape, IsTheSameForASeedAndWithinItsRanges) {
  EXPECT_EQ(headShape(0), HeadShape{});
  EXPECT_EQ(headShape(7), headShape(7));
  EXPECT_NE(headShape(7), headShape(8));
  for (int seed = 1; seed < 200; ++seed) {
    const HeadShape shape = headShape(seed);
    EXPECT_GE(shape.size, kSmallestHead);
    EXPECT_LE(shape.size, kLargestHead);
    for (const HeadTrait& trait : headTraits())
      EXPECT_LE(std::abs(shape.*trait.number - HeadShape{}.*trait.number), 2.001f * trait.spread)
          << trait.name;
  }
}

TEST(HeadShape, EveryTraitVariesAsMuchAsItSays) {
  for (const HeadTrait& trait : headTraits()) {
    double sum = 0;
    constexpr int kHeads = 400;
    for (int seed = 1; seed <= kHeads; ++seed)
      sum += std::pow(double(headShape(seed).*trait.number - HeadShape{}.*trait.number), 2);
    EXPECT_NEAR(std::sqrt(sum / kHeads) / double(trait.spread), 0.96, 0.1) << trait.name;
  }
}

// Each trait of the list changes the skin, or it would be a number without a meaning.
TEST(HeadShape, EveryTraitMovesTheSkin) {
  for (const HeadTrait& trait : headTraits()) {
    HeadShape shape;
    shape.*trait.number += 2 * trait.spread;
    float most = 0;
    Places places;
    for (int n = 0; n < 100000; ++n) {
      const vec3 p = places.next();
      const float d = headSkin(p);
      if (std::abs(d) < 0.5f) most = std::max(most, std::abs(headSkin(p, shape) - d));
    }
    EXPECT_GT(most, 0.06f) << trait.name;
    EXPECT_LT(most, 8.f) << trait.name;
  }
}

}  // namespace
}  // namespace sonoskin
