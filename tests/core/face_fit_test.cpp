#include "core/face/face_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/face/face_refine.h"
#include "core/phantom/random_field.h"
#include "tests/support/face_points.h"
#include "tests/support/first_phantom.h"

namespace sonoskin {
namespace {

using glm::vec3;
using test::SampledFace;
using test::SampleOptions;

std::vector<float> errorsOf(const SampledFace& face, const FaceFit& fit) {
  const HeadPlaces truth = headPlaces(face.shape);
  std::vector<float> errors;
  const auto add = [&](const vec3& head, const vec3& found) {
    errors.push_back(glm::distance(face.at + face.turn * head, found));
  };
  add(truth.rightEye, fit.places.rightEye);
  add(truth.leftEye, fit.places.leftEye);
  add(truth.noseTip, fit.places.noseTip);
  add(truth.mouthRight, fit.places.mouthRight);
  add(truth.mouthLeft, fit.places.mouthLeft);
  add(truth.chin, fit.places.chin);
  return errors;
}

float degreesBetween(const vec3& a, const vec3& b) {
  return glm::degrees(std::acos(std::clamp(glm::dot(a, b), -1.f, 1.f)));
}

TEST(FaceFit, FindsTheFirstHeadExactly) {
  const SampledFace face = test::sampleFace(HeadShape{}, vec3(0));
  const FaceFit fit = fitFace(face.input());
  EXPECT_GT(fit.confidence, 0.9f);
  for (const float error : errorsOf(face, fit)) EXPECT_LT(error, 1.f);
  EXPECT_LT(degreesBetween(fit.front, face.turn[2]), 2);
  EXPECT_LT(degreesBetween(fit.up, face.turn[1]), 2);
  EXPECT_NEAR(fit.headHeight, 92, 3);
}

// Heads of the family in all turns, with noise, strays, an arm, and a side that no beam reached.
TEST(FaceFit, FindsHeadsOfTheFamilyInAllTurns) {
  struct Case {
    vec3 turn;
    SampleOptions sample;
  };
  const Case cases[] = {
      {{0, 0, 180}, {.noise = 0.5f}},
      {{30, -15, 70}, {.noise = 0.5f, .outliers = 0.05f, .arm = true}},
      {{-40, 10, -100}, {.noise = 0.8f, .outliers = 0.03f}},
      {{15, 20, 20}, {.noise = 0.5f, .hidden = 20, .arm = true}},
      {{-20, -20, -30}, {.noise = 1, .outliers = 0.05f}},
      {{45, 5, 130}, {.noise = 0.4f}},
  };
  std::vector<float> all;
  int seed = 1;
  for (const Case& c : cases) {
    const SampledFace face = test::sampleFace(headShape(seed), c.turn, c.sample);
    const FaceFit fit = fitFace(face.input());
    EXPECT_GT(fit.confidence, 0.5f) << seed;
    EXPECT_LT(degreesBetween(fit.front, face.turn[2]), 10) << seed;
    EXPECT_LT(degreesBetween(fit.up, face.turn[1]), 10) << seed;
    EXPECT_NEAR(fit.headHeight / 92, face.shape.size, 0.07) << seed;
    for (const float error : errorsOf(face, fit)) all.push_back(error);
    ++seed;
  }
  std::sort(all.begin(), all.end());
  EXPECT_LT(all[all.size() / 2], 1.2f);
  EXPECT_LT(all[all.size() * 95 / 100], 4.f);
}

// Points alone, without a volume, are enough.
TEST(FaceFit, NeedsNoVolume) {
  const SampledFace face = test::sampleFace(headShape(4), vec3(10, -10, 45), {.noise = 0.4f});
  const FaceFit fit = fitFace({face.points, nullptr, 0, face.beam});
  EXPECT_GT(fit.confidence, 0.5f);
  EXPECT_LT(errorsOf(face, fit)[2], 2);
}

void expectNoFace(const SurfacePoints& points, const char* what) {
  const Beam beam{std::nullopt, {0, 0, -1}, {0, 1, 0}};
  EXPECT_LT(fitFace({points, nullptr, 0, beam}).confidence, 0.5f) << what;
}

TEST(FaceFit, SeesNoFaceWhereThereIsNone) {
  const SampleOptions noisy{.spacing = 1, .noise = 0.5f, .outliers = 0.03f};
  expectNoFace(test::sampleSurface([](const vec3& p) { return glm::length(p) - 42; }, 60, noisy), "ball");
  expectNoFace(test::sampleSurface([](const vec3& p) { return p.z - 0.1f * p.x; }, 60, noisy), "plane");
  const auto bumpy = [](const vec3& p) {
    return 0.9f * (glm::length(p) - 42 - 6 * (valueNoise(p + 100.f, 12, 7) - 0.5f) -
                   4 * (valueNoise(p + 100.f, 7, 8) - 0.5f));
  };
  expectNoFace(test::sampleSurface(bumpy, 60, noisy), "bumpy ball");
  const auto back = [](const vec3& p) { return headSkin({-p.x, p.y, -p.z}); };
  expectNoFace(test::sampleSurface(back, 60, noisy), "back of the head");
  const auto wall = [](const vec3& p) {
    const glm::dvec3 world{70 + double(p.x), 10 - double(p.z), 56 + double(p.y)};
    return float(test::wallDistance(world));
  };
  expectNoFace(test::sampleSurface(wall, 50, noisy), "wall of the uterus");
}

TEST(FaceFit, SeesNoFaceInScatteredPoints) {
  SurfacePoints points;
  std::uint32_t n = 0;
  while (points.size() < 20000) {
    const auto in = [&] { return 2 * uniformAt(n++, 5) - 1; };
    const vec3 p{in(), in(), in()};
    const vec3 q{in(), in(), in()};
    points.positions.push_back(50.f * p);
    points.normals.push_back(glm::normalize(q));
    points.confidence.push_back(1);
  }
  expectNoFace(points, "random points");
}

TEST(FaceFit, AFewPointsAreNoFace) {
  SurfacePoints points;
  EXPECT_EQ(fitFace({points}).confidence, 0);
  for (int n = 0; n < 600; ++n) {
    points.positions.emplace_back(1, 2, 3);
    points.normals.emplace_back(0, 0, 1);
    points.confidence.push_back(1);
  }
  EXPECT_EQ(fitFace({points}).confidence, 0) << "all at one place";
}

TEST(FaceFit, IsTheSameWithOneThreadAndTwo) {
  const SampledFace face = test::sampleFace(headShape(2), vec3(20, 5, 10), {.spacing = 1.2f});
  setThreadCount(1);
  const FaceFit one = fitFace(face.input());
  setThreadCount(2);
  const FaceFit two = fitFace(face.input());
  setThreadCount(0);
  EXPECT_EQ(one.places.noseTip, two.places.noseTip);
  EXPECT_EQ(one.confidence, two.confidence);
}

TEST(FaceFit, CanBeCancelled) {
  const SampledFace face = test::sampleFace(HeadShape{}, vec3(0), {.spacing = 2});
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(fitFace(face.input(), {}, Progress(sink)), Cancelled);
}

// From 6 mm and 10 degrees off.
TEST(RefineFace, ComesBackFromNearby) {
  const SampledFace face = test::sampleFace(HeadShape{}, vec3(0));
  const FaceSpace space(face.input());
  FacePlacement start;
  start.at = face.at + vec3(4, -3, 3);
  start.scale = 0.93f;
  const float angle = glm::radians(10.f);
  start.turn = glm::mat3(std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle), 0, 0, 0, 1);
  const FacePlacement found = refineFace(start, space, {}, {12, 900, 8, 3, true});
  EXPECT_LT(glm::distance(found.at, face.at), 1.5f);
  EXPECT_NEAR(found.scale, 1, 0.03);
  EXPECT_LT(degreesBetween(found.up(), face.turn[1]), 1.5f);
}

}  // namespace
}  // namespace sonoskin
