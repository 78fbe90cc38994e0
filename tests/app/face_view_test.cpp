#include "app/document/face_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/batch/face_report.h"

namespace sonoskin {
namespace {

using glm::vec3;

constexpr float kDegree = 0.01745329f;

// A face that looks toward -y, turned by some degrees about z, which is its up.
FaceFit turnedFace(float degrees) {
  FaceFit face;
  face.confidence = 0.9f;
  face.up = {0, 0, 1};
  face.front = {std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0};
  face.headHeight = 90;
  const vec3 left = glm::cross(face.up, face.front);
  face.placement.turn = glm::mat3(left, face.up, face.front);
  return face;
}

// A head of a ball's size around the origin, and a body far below.
std::vector<vec3> headAndBody() {
  std::vector<vec3> points;
  for (float z = -45; z <= 45; z += 5)
    for (float x = -25; x <= 25; x += 5) points.emplace_back(x, -10, z);
  for (float x = -90; x <= 90; x += 5) points.emplace_back(x, 0, -150);
  return points;
}

TEST(FaceView, LooksTheFaceInTheEyesAndUpright) {
  const FaceFit face = turnedFace(10);
  const Camera camera = cameraOnFace(headAndBody(), &face, Beam{}, 1);
  EXPECT_LT(glm::distance(camera.forward, -face.front), 1e-4f);
  EXPECT_GT(glm::dot(camera.up, face.up), 0.999f);
}

TEST(FaceView, StaysNearTheBeamsOfATurnedHead) {
  const FaceFit face = turnedFace(70);
  const Camera camera = cameraOnFace(headAndBody(), &face, Beam{}, 1);
  EXPECT_NEAR(glm::dot(camera.forward, vec3(0, 1, 0)), std::cos(12 * kDegree), 1e-3);
  EXPECT_GT(glm::dot(camera.forward, -face.front), std::cos(59 * kDegree));
}

TEST(FaceView, FillsTheFrameWithTheHead) {
  const FaceFit face = turnedFace(0);
  const std::vector<vec3> points = headAndBody();
  EXPECT_LT(cameraOnFace(points, &face, Beam{}, 1).distance,
            0.7f * cameraOnFace(points, nullptr, Beam{}, 1).distance);
  EXPECT_TRUE(isTall(points, &face, Beam{}));
  Beam beam;
  beam.up = {0, 0, 1};
  EXPECT_FALSE(isTall(points, nullptr, beam)) << "all of it is nearly square";
}

TEST(FaceView, ShowsAChinThatLiesLow) {
  FaceFit face = turnedFace(0);
  const Camera usual = cameraOnFace(headAndBody(), &face, Beam{}, 1);
  face.headHeight = 40;
  face.places.chin = {0, -10, -35};
  EXPECT_NEAR(cameraOnFace(headAndBody(), &face, Beam{}, 1).distance, usual.distance, 0.15f * usual.distance);
}

TEST(FaceView, ABodyWithoutPointsNearTheFaceIsShownWhole) {
  const FaceFit face = turnedFace(0);
  const std::vector<vec3> far{{500, 0, 0}, {520, 0, 10}};
  EXPECT_GT(cameraOnFace(far, &face, Beam{}, 1).target.x, 490);
}

TEST(FaceReport, SaysWhatWasFoundOrOnlyHowUncertainItIs) {
  FaceFit face = turnedFace(0);
  face.headHeight = 30;
  auto json = nlohmann::json::parse(faceJson(reportFace(&face, {})));
  EXPECT_TRUE(json["used"].get<bool>());
  EXPECT_EQ(json["landmarks"]["chin"].size(), 3u);
  EXPECT_NEAR(json["head_height_mm"].get<double>(), 30, 1e-4);
  EXPECT_FALSE(json.contains("warning"));  // it is one of the run's
  face.confidence = 0.1f;
  json = nlohmann::json::parse(faceJson(reportFace(&face, {})));
  EXPECT_FALSE(json["used"].get<bool>());
  EXPECT_FALSE(json.contains("landmarks"));
  EXPECT_NEAR(json["confidence"].get<double>(), 0.1, 1e-5);
  EXPECT_FALSE(reportFace(nullptr, {}).fit.has_value());
}

}  // namespace
}  // namespace sonoskin
