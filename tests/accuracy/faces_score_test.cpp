// The score of `sonoskin_accuracy --faces` on surfaces whose score is known.
#include "tests/benchmarks/accuracy/faces_score.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mesh/components.h"
#include "core/phantom/phantom.h"
#include "tests/benchmarks/accuracy/faces_spurs.h"
#include "tests/support/meshes.h"

namespace sonoskin::accuracy {
namespace {

using test::icosphere;

constexpr float kRadius = 20;

FaceAnatomy nothingElse() { return {}; }

// A ball as baby; the probe, at -y, sees the half before it.
Mesh ball() {
  Mesh mesh = icosphere(5, kRadius, {0, 0, 0});
  for (const glm::vec3& p : mesh.positions) mesh.visibility.push_back(p.y < 0 ? 1.f : 0.f);
  return mesh;
}

// The triangles of a mesh whose corners all satisfy a condition.
template <class Condition>
Mesh partOf(Mesh mesh, const Condition& keep) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return !std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return keep(mesh.positions[v]); });
  });
  return mesh;
}

double areaOf(double radius) { return 4 * std::numbers::pi * radius * radius; }

// A strip that stands on the ball at -y: 2 mm wide, outward from the skin as far as `length`.
Mesh fin(float length) {
  Mesh mesh;
  const int steps = int(length / 0.5f);
  for (int i = 0; i <= steps; ++i)
    for (const float x : {-1.f, 1.f}) mesh.positions.emplace_back(x, -kRadius - 0.5f * float(i), 0);
  for (std::uint32_t i = 0; i < std::uint32_t(steps); ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
    mesh.triangles.push_back({2 * i + 2, 2 * i + 1, 2 * i + 3});
  }
  computeNormals(mesh);
  mesh.visibility.assign(mesh.positions.size(), 1);
  return mesh;
}

TEST(FacesScore, TruthIsPerfect) {
  const FaceTruth truth(ball(), nothingElse());
  const FaceScore score = scoreFace(ball(), truth);
  EXPECT_LT(score.rms, 1e-4);
  EXPECT_LT(score.max, 1e-3);
  EXPECT_NEAR(score.offset, 0, 1e-4);
  EXPECT_EQ(score.covered, 1);
  EXPECT_EQ(score.foreign, 0);
  EXPECT_EQ(score.spurs, 0);
  EXPECT_EQ(score.spurless, 1);
  EXPECT_LT(score.interior, 1e-4);
  EXPECT_TRUE(std::isnan(score.border)) << "a closed surface has no border";
  EXPECT_TRUE(std::isnan(score.coveredFace)) << "there are no labels";
  EXPECT_TRUE(std::isnan(score.detail)) << "there are no features";
  EXPECT_NEAR(score.area, areaOf(kRadius), 0.01 * areaOf(kRadius));
}

TEST(FacesScore, AnOffsetIsItsDistance) {
  const FaceTruth truth(ball(), nothingElse());
  for (const float offset : {0.5f, -0.5f}) {
    const FaceScore score = scoreFace(icosphere(5, kRadius + offset, {0, 0, 0}), truth);
    EXPECT_NEAR(score.rms, 0.5, 0.01);
    EXPECT_NEAR(score.p95, 0.5, 0.01);
    EXPECT_NEAR(score.offset, offset, 0.01);
    EXPECT_EQ(score.covered, 1);
  }
  const FaceScore far = scoreFace(icosphere(5, kRadius + 1.1f, {0, 0, 0}), truth);
  EXPECT_EQ(far.covered, 0);
  EXPECT_EQ(far.spurs, 0);
  EXPECT_NEAR(far.rms, 1.1, 0.01);
}

TEST(FacesScore, OnlyWhatTheProbeSeesCounts) {
  const FaceTruth truth(ball(), nothingElse());
  // Right before the equator, 2 mm off beyond it: nothing of that is seen.
  Mesh mesh = ball();
  for (glm::vec3& p : mesh.positions)
    if (p.y > 2) p *= 1.1f;
  EXPECT_LT(scoreFace(mesh, truth).rms, 0.01);
  // A quarter of the ball is half of what is seen.
  const Mesh quarter = partOf(ball(), [](const glm::vec3& p) { return p.y < 0 && p.x < 0; });
  EXPECT_NEAR(scoreFace(quarter, truth).covered, 0.5, 0.03);
}

TEST(FacesScore, LabelsHaveSharesOfTheirOwn) {
  Mesh labelled = ball();
  for (const glm::vec3& p : labelled.positions)
    labelled.labels.push_back(std::uint8_t(p.x < 0 ? BodyPart::face : BodyPart::hand));
  const FaceTruth truth(labelled, nothingElse());
  const FaceScore score = scoreFace(partOf(ball(), [](const glm::vec3& p) { return p.x < 0; }), truth);
  EXPECT_GT(score.coveredFace, 0.98);
  EXPECT_LT(score.coveredHand, 0.06);
  EXPECT_TRUE(std::isnan(score.coveredBody));
}

TEST(FacesScore, ForeignTissueIsAShareAndNoDistance) {
  const FaceTruth truth(ball(), nothingElse());
  const Mesh other = icosphere(4, 5, {0, -30, 0});  // 5 mm before the baby
  const FaceScore score = scoreFace(joinPieces({ball(), other}), truth);
  EXPECT_NEAR(score.foreign, 25.0 / 425, 0.003);
  EXPECT_LT(score.rms, 0.01);
  EXPECT_NEAR(score.maxAll, 15, 0.1);
  EXPECT_GT(score.rmsAll, 2);
  EXPECT_EQ(score.spurs, 1);
  EXPECT_NEAR(score.spurArea, areaOf(5), 0.02 * areaOf(5));
  EXPECT_EQ(score.tissue, 0) << "nothing is known of it";
  FaceAnatomy anatomy;
  anatomy.other = [](const glm::dvec3& p) { return p.y + 31; };  // a half space; 6 mm of the sphere's 10
  EXPECT_NEAR(scoreFace(joinPieces({ball(), other}), FaceTruth(ball(), anatomy)).tissue, 15.0 / 425, 0.003);
}

TEST(FacesScore, AFinIsOneSpur) {
  const FaceTruth truth(ball(), nothingElse());
  const Mesh mesh = joinPieces({ball(), fin(6)});
  const FaceScore score = scoreFace(mesh, truth);
  EXPECT_EQ(score.spurs, 1);
  EXPECT_EQ(score.spurless, 0);
  EXPECT_NEAR(score.spurY, -kRadius - 3.75, 0.3);
  EXPECT_NEAR(score.spurArea, 2 * 4.5, 1.1);  // from 1.5 mm outward
  EXPECT_NEAR(double(glm::distance(findSpurs(mesh, truth).largest, {0, -kRadius - 3.75f, 0})), 0, 0.3);
  const FaceScore two =
      scoreFace(joinPieces({mesh, icosphere(3, 1, {0, 30, 0}), icosphere(2, 1, {30, 0, 0})}), truth);
  EXPECT_EQ(two.spurs, 3);
  EXPECT_EQ(scoreFace(joinPieces({ball(), fin(1.9f)}), truth).spurs, 0) << "it does not stand off by 2 mm";
}

TEST(FacesScore, TheBorderIsApart) {
  const FaceTruth truth(ball(), nothingElse());
  // A cap around -y whose outermost 3 mm are bent outward.
  Mesh cap = partOf(icosphere(6, kRadius, {0, 0, 0}), [](const glm::vec3& p) { return p.y < -10; });
  for (glm::vec3& p : cap.positions)
    if (p.y > -12) p *= 1.05f;
  const FaceScore score = scoreFace(cap, truth);
  EXPECT_GT(score.border, 0.6);
  EXPECT_LT(score.border, 1);
  EXPECT_LT(score.interior, 0.05);
}

TEST(FacesScore, DetailIsTheAngleBetweenNormals) {
  FaceAnatomy anatomy;
  anatomy.features.nose = {{0, -kRadius, 0}, 6};
  const FaceTruth truth(ball(), anatomy);
  EXPECT_LT(scoreFace(ball(), truth).nose, 0.5);
  EXPECT_TRUE(std::isnan(scoreFace(ball(), truth).eyes));

  Mesh turned = ball();  // normals by 10 degrees
  for (glm::vec3& n : turned.normals) {
    const glm::vec3 side = glm::normalize(glm::cross(n, glm::vec3(1, 0, 0)));
    n = glm::normalize(n + std::tan(glm::radians(10.f)) * side);
  }
  EXPECT_NEAR(scoreFace(turned, truth).detail, 10, 0.5);

  Mesh insideOut = ball();
  for (glm::vec3& n : insideOut.normals) n = -n;
  EXPECT_LT(scoreFace(insideOut, truth).detail, 0.5) << "which side is out is not what is asked";

  const Mesh holed = partOf(ball(), [](const glm::vec3& p) { return glm::length(glm::vec2(p.x, p.z)) > 9; });
  EXPECT_NEAR(scoreFace(holed, truth).nose, 90, 1) << "what is not there has no right normal";
}

TEST(FacesScore, ThePhantomBringsItsAnatomy) {
  PhantomOptions options;
  options.dims = {60, 40, 16};
  const FaceTruth truth(makePhantomTruth(options), phantomAnatomy(options));
  const FaceScore score = scoreFace(truth.skin(), truth);
  for (const double share : {score.covered, score.coveredFace, score.coveredHead, score.coveredHand})
    EXPECT_EQ(share, 1);
  EXPECT_LT(score.eyes, 1);
  EXPECT_LT(score.nose, 1);
  EXPECT_LT(score.mouth, 1);
  const FacePose& pose = truth.pose();
  const glm::dvec3 eyes = 0.5 * (pose.places.rightEye + pose.places.leftEye);
  EXPECT_GT(glm::dot(eyes - 0.5 * (pose.places.mouthRight + pose.places.mouthLeft), pose.up), 15);
  EXPECT_GT(glm::dot(pose.places.noseTip - eyes, pose.front), 5);
  EXPECT_NEAR(glm::dot(pose.up, pose.front), 0, 1e-5);
  const FaceScore shifted = scoreFace(joinPieces({truth.skin(), icosphere(4, 8, {20, 5, 20})}), truth);
  EXPECT_GT(shifted.tissue, 0) << "the wall lies there";
  EXPECT_NEAR(shifted.tissue, shifted.foreign, 0.01);
}

TEST(FacesScore, NothingCoversNothing) {
  const FaceTruth truth(ball(), nothingElse());
  const FaceScore score = scoreFace(Mesh{}, truth);
  EXPECT_EQ(score.covered, 0);
  EXPECT_TRUE(std::isnan(score.rms));
}

}  // namespace
}  // namespace sonoskin::accuracy
