#include "tests/benchmarks/accuracy/faces_pose.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin::accuracy {
namespace {

FacePose someFace() {
  return {{{-14, 0, 30}, {14, 0, 30}, {0, -10, 40}, {-10, -25, 30}, {10, -25, 30}}, {0, 1, 0}, {0, 0, 1}};
}

TEST(FacesPose, TheSameFaceIsRight) {
  FaceScore score;
  comparePose(someFace(), someFace(), 0.9, score);
  EXPECT_EQ(score.landmarks, 0);
  EXPECT_LT(score.pose, 1e-4);
  EXPECT_EQ(score.confidence, 0.9);
  EXPECT_EQ(score.misled, 0);
}

TEST(FacesPose, MeansAndTurnsAreThoseOfTheirDefinition) {
  FacePose found = someFace();
  found.places.noseTip.x += 5;
  const double angle = glm::radians(7.0);
  found.up = {0, std::cos(angle), std::sin(angle)};
  found.front = {0, -std::sin(angle), std::cos(angle)};
  FaceScore score;
  comparePose(found, someFace(), 1, score);
  EXPECT_NEAR(score.landmarks, 1, 1e-9);
  EXPECT_NEAR(score.landmarksMax, 5, 1e-9);
  EXPECT_NEAR(score.pose, 7, 1e-6);
  found.up = {0, -1, 0}, found.front = {0, 0, 1};  // upside down
  comparePose(found, someFace(), 1, score);
  EXPECT_NEAR(score.pose, 180, 1e-3);
}

TEST(FacesPose, OnlyAWrongFaceThatIsSureMisleads) {
  FacePose wrong = someFace();
  for (glm::dvec3* p : {&wrong.places.rightEye, &wrong.places.leftEye, &wrong.places.noseTip,
                        &wrong.places.mouthRight, &wrong.places.mouthLeft})
    p->z += 30;
  FaceScore score;
  comparePose(wrong, someFace(), 0.8, score);
  EXPECT_EQ(score.misled, 1);
  comparePose(wrong, someFace(), 0.2, score);
  EXPECT_EQ(score.misled, 0);
}

}  // namespace
}  // namespace sonoskin::accuracy
