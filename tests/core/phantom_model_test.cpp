#include "core/phantom/phantom_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/phantom/phantom.h"
#include "core/phantom/phantom_geometry.h"
#include "core/phantom/scene_plan.h"
#include "core/pipeline/phantom_landmarks.h"
#include "tests/support/first_phantom.h"

namespace sonoskin {
namespace {

using glm::dvec3;

PhantomOptions sceneOf(PhantomScene scene, int shape = 0, int seed = 1) {
  PhantomOptions options;
  options.dims = {94, 51, 31};
  options.scene = scene;
  options.shape = shape;
  options.seed = seed;
  return options;
}

std::vector<dvec3> placesOf(const FacePlaces& f) {
  return {f.rightEye, f.leftEye, f.noseTip, f.mouthRight, f.mouthLeft};
}

// towardProbe: the cosine between where the face looks and the way to the probe.
double towardProbe(const HeadPose& pose) { return -(pose.toWorld({0, 0, 1}) - pose.toWorld({0, 0, 0})).y; }

TEST(PhantomModel, TheFirstIsTheOneItAlwaysWas) {
  struct Known {
    dvec3 p;
    double skin, wall, bone;
  };
  const Known known[] = {
      {{57, 30, 50}, 1.093581, 22.099649, 5.052380},   {{68, 26, 50}, -0.191183, 18.190203, 10.925807},
      {{82, 34, 47}, -1.598710, 26.626390, 10.424741}, {{90, 28, 72}, -0.669384, 18.254185, 1.918110},
      {{20, 60, 60}, -9.547777, 40.722557, 4.020248},  {{120, 70, 40}, -4.077281, 39.688473, 2.291993},
      {{14, 15, 95}, 35.091400, -6.534159, 38.873398}, {{70, 9, 56}, 17.621319, 1.327386, 20.801086},
      {{60, 50, 90}, 5.323738, 34.487823, 10.741592}};
  const PhantomModel model{PhantomOptions{}};
  for (const auto& [p, skin, wall, bone] : known) {
    EXPECT_NEAR(model.skin(p), skin, 1e-4) << p.x;
    EXPECT_NEAR(model.wall(p), wall, 1e-4) << p.x;
    EXPECT_NEAR(model.bone(p), bone, 1e-4) << p.x;
    EXPECT_EQ(model.skin(p), test::skinDistance(p));
  }
  EXPECT_FALSE(model.isCrowded());
  EXPECT_GT(model.strands({70, 40, 56}), 100);
}

TEST(PhantomModel, OnlyTheSpeckleOfTheFirstScenesDependsOnTheSeed) {
  for (const PhantomScene scene : {PhantomScene::clear, PhantomScene::thick, PhantomScene::haze,
                                   PhantomScene::saturated, PhantomScene::enhanced, PhantomScene::planes}) {
    const PhantomModel first{PhantomOptions{}}, other(sceneOf(scene, 0, 5));
    for (double x = 5; x < 140; x += 13) EXPECT_EQ(first.skin({x, 40, 50}), other.skin({x, 40, 50}));
  }
}

TEST(PhantomModel, LandmarksLieOnTheSkinOfEveryHeadInEveryScene) {
  int free = 0, covered = 0;
  for (int scene = 0; scene <= int(PhantomScene::clinical); ++scene)
    for (int shape = 0; shape < 4; ++shape) {
      const PhantomOptions options = sceneOf(PhantomScene(scene), shape, 1 + shape);
      const PhantomModel model(options);
      for (const dvec3& p : placesOf(model.facePlaces())) {
        const double d = model.skin(p);
        ASSERT_LT(d, 0.05) << scene << ' ' << shape;
        ASSERT_GT(d, -8) << "no hand is thicker";
        ++(std::abs(d) < 0.05 ? free : covered);
      }
      const FacePlaces f = model.facePlaces();
      EXPECT_GT(model.head().toHead(f.noseTip).z, 28) << "the nose is before the head";
      EXPECT_NEAR(glm::distance(f.rightEye, f.leftEye), 28.8 * double(model.headShape().size), 5);
      EXPECT_NEAR(phantomLandmarks(options).noseTip[0], f.noseTip.x, 0.051);
    }
  EXPECT_GT(free, 8 * covered);
}

TEST(PhantomModel, PoseIsARigidMotion) {
  const PhantomModel model(sceneOf(PhantomScene::turned, 2, 9));
  const glm::vec3 a{3, -20, 40}, b{-30, 11, 5};
  EXPECT_NEAR(glm::distance(model.head().toWorld(a), model.head().toWorld(b)), glm::distance(a, b), 1e-3);
  EXPECT_LT(glm::distance(model.head().toHead(model.head().toWorld(a)), a), 1e-3f);
}

TEST(PhantomModel, TurnedHeadsLookAsideButNotAway) {
  int left = 0, tilted = 0;
  for (int seed = 0; seed < 24; ++seed) {
    const PhantomModel model(sceneOf(PhantomScene::turned, seed % 3, seed));
    const double cosine = towardProbe(model.head());
    EXPECT_LT(cosine, std::cos(glm::radians(24.))) << seed;
    EXPECT_GT(cosine, std::cos(glm::radians(62.))) << seed;
    const dvec3 up = model.head().toWorld({0, 1, 0}) - model.head().toWorld({0, 0, 0});
    tilted += std::abs(up.z) > std::sin(glm::radians(8.));
    left += (model.head().toWorld({0, 0, 1}) - model.head().toWorld({0, 0, 0})).z > 0;
  }
  EXPECT_GT(left, 6);
  EXPECT_LT(left, 18);
  EXPECT_GT(tilted, 8);
}

// In every scene of another pose the probe sees a good part of the face.
TEST(PhantomModel, TheFaceIsInView) {
  for (const PhantomScene scene : {PhantomScene::clear, PhantomScene::turned, PhantomScene::attached,
                                   PhantomScene::cord, PhantomScene::hands, PhantomScene::clinical}) {
    const Mesh truth = makePhantomTruth(sceneOf(scene, 1 + int(scene) % 3, 3 + int(scene)));
    double face = 0, seen = 0;
    std::set<int> labels;
    for (std::size_t v = 0; v < truth.positions.size(); ++v) {
      labels.insert(truth.labels[v]);
      if (truth.labels[v] != std::uint8_t(BodyPart::face)) continue;
      face += 1, seen += double(truth.visibility[v]);
    }
    EXPECT_GT(seen, 0.35 * face) << int(scene);
    EXPECT_EQ(labels, (std::set<int>{1, 2, 3, 4})) << int(scene);
  }
}

// onSkin: f(place, part) for places within 1 mm of the skin, on a grid.
template <class F>
void onSkin(const PhantomModel& model, F&& f) {
  constexpr double kStep = 1.6;
  for (double x = kStep; x < kFieldOfView.x; x += kStep)
    for (double y = kStep; y < kFieldOfView.y; y += kStep)
      for (double z = kStep; z < kFieldOfView.z; z += kStep)
        if (const dvec3 p{x, y, z}; std::abs(model.skin(p)) < 1) f(p, model.part(p));
}

// faceNearOther: the share of the face's skin that other tissue comes nearer to than some mm.
double faceNearOther(const PhantomOptions& options, double near) {
  const PhantomModel model(options);
  double all = 0, close = 0;
  onSkin(model, [&](const dvec3& p, BodyPart part) {
    if (part == BodyPart::face) all += 1, close += model.other(p) < near;
  });
  return close / all;
}

TEST(PhantomModel, OtherTissueTouchesTheFaceWhereTheSceneSaysSo) {
  EXPECT_EQ(faceNearOther(sceneOf(PhantomScene::clear), 3), 0);
  for (const int seed : {1, 2, 3}) {
    EXPECT_GT(faceNearOther(sceneOf(PhantomScene::attached, seed, seed), 1), 0.003) << seed;
    EXPECT_GT(faceNearOther(sceneOf(PhantomScene::cord, seed, seed), 1), 0.002) << seed;
    EXPECT_LT(faceNearOther(sceneOf(PhantomScene::clinical, seed, seed), 0), 0.3) << seed;
  }
}

TEST(PhantomModel, SkinUnderOtherTissueCannotBeSeen) {
  const PhantomOptions options = sceneOf(PhantomScene::attached, 2, 2);
  const Mesh truth = makePhantomTruth(options);
  const PhantomModel model(options);
  int covered = 0;
  for (std::size_t v = 0; v < truth.positions.size(); ++v) {
    if (model.other(dvec3(truth.positions[v])) >= 0) continue;
    ++covered;
    ASSERT_EQ(truth.visibility[v], 0);
  }
  EXPECT_GT(covered, 50);
}

TEST(PhantomModel, CordIsAsThickAsACord) {
  for (const int seed : {1, 2, 3, 4}) {
    const PhantomModel model(sceneOf(PhantomScene::cord, 0, seed));
    ASSERT_TRUE(model.hasStrands());
    double deepest = 0;
    for (double x = 20; x < 130; x += 1.5)
      for (double y = 10; y < 70; y += 1.5)
        for (double z = 10; z < 100; z += 1.5) deepest = std::min(deepest, model.strands({x, y, z}));
    EXPECT_LT(deepest, -4) << seed;
    EXPECT_GT(deepest, -7.1) << seed;
  }
}

TEST(PhantomModel, TissueIsAttachedBesideTheFace) {
  const PhantomModel model(sceneOf(PhantomScene::attached));
  EXPECT_EQ(model.part(model.facePlaces().noseTip), BodyPart::face);
  int found = 0;
  for (double x = 10; x < 130; x += 2)
    for (double y = 5; y < 70; y += 2)
      for (double z = 5; z < 105; z += 2) {
        const dvec3 p{x, y, z};
        found += std::abs(model.other(p)) <= 0.3 && model.skin(p) >= 1;
      }
  EXPECT_GT(found, 50);
}

// middleOfHands: in the head's frame, of what belongs to hands and lies above the shoulders.
dvec3 middleOfHands(const PhantomOptions& options) {
  const PhantomModel model(options);
  dvec3 sum(0);
  int count = 0;
  onSkin(model, [&](const dvec3& p, BodyPart part) {
    const glm::vec3 head = model.head().toHead(p);
    if (part == BodyPart::hand && head.y > -45) sum += dvec3(head), ++count;
  });
  EXPECT_GT(count, 100);
  return sum / double(std::max(count, 1));
}

TEST(PhantomModel, HandsLieInOtherPlaces) {
  const dvec3 usual = middleOfHands(sceneOf(PhantomScene::clear));
  std::vector<dvec3> places;
  for (int seed = 0; seed < 6; ++seed) places.push_back(middleOfHands(sceneOf(PhantomScene::hands, 0, seed)));
  EXPECT_GT(places[0].y, usual.y + 15) << "temple";
  EXPECT_GT(places[5].y, usual.y + 25) << "forehead";
  EXPECT_LT(std::abs(places[3].x), 8) << "both cheeks";
  EXPECT_GT(std::abs(places[2].x), 8) << "one eye";
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_GT(glm::distance(places[a], places[b]), 4) << a << ' ' << b;
}

}  // namespace
}  // namespace sonoskin
