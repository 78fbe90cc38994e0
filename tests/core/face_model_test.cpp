#include "core/face/face_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/face/face_placement.h"

namespace sonoskin {
namespace {

using glm::vec3;

TEST(FaceModel, ItsPointsLieOnTheFrontOfTheFirstHead) {
  const FaceModel& model = faceModel();
  double weights = 0;
  for (const FacePoint& point : model.points) {
    EXPECT_NEAR(headSkin(point.place), 0, 0.02);
    EXPECT_NEAR(glm::length(point.normal), 1, 1e-4);
    EXPECT_LT(headSkin(point.place - 0.5f * point.normal), 0);
    EXPECT_GT(point.place.z, 0);
    weights += double(point.weight);
  }
  EXPECT_NEAR(weights, 1, 1e-4);
  EXPECT_GT(model.inner.size(), model.points.size() / 8);
}

TEST(FaceModel, EveryPrefixIsSpreadOverTheFace) {
  const FaceModel& model = faceModel();
  for (const FacePoint& point : model.points) {
    float nearest = 1e9f;
    for (std::size_t i = 0; i < 96; ++i)
      nearest = std::min(nearest, glm::distance(point.place, model.points[i].place));
    EXPECT_LT(nearest, 16);
  }
}

TEST(FaceModel, TheSharesAroundAPointAreOne) {
  for (const FaceModel::Inner& inner : faceModel().inner) {
    float sum = 0;
    for (const FaceNeighbour& neighbour : inner.around) sum += neighbour.share;
    EXPECT_NEAR(sum, 1, 1e-4);
  }
}

TEST(FaceModel, ItsModesAreNoMotionsOfTheWhole) {
  const FaceModel& model = faceModel();
  for (std::size_t mode = 0; mode < kFaceModes; ++mode) {
    double along = 0, forward = 0, size = 0;
    for (const FacePoint& point : model.points) {
      along += double(point.weight) * std::pow(double(point.along[mode]), 2);
      forward += double(point.weight * point.along[mode] * point.normal.z);
      size += double(point.weight * point.along[mode] * glm::dot(point.place, point.normal));
    }
    EXPECT_GT(along, 0);
    EXPECT_NEAR(forward, 0, 1e-3);
    EXPECT_NEAR(size, 0, 2e-2);
  }
}

// What the modes were made for: a head that differs in one trait is closer to the model with modes than without.
TEST(FaceModel, TheMainModesMoveMoreThanTheLast) {
  const FaceModel& model = faceModel();
  const auto moved = [&](std::size_t mode) {
    double sum = 0;
    for (const FacePoint& p : model.points) sum += double(p.weight) * std::pow(double(p.along[mode]), 2);
    return std::sqrt(sum);
  };
  for (std::size_t mode = 1; mode < kFaceModes; ++mode) EXPECT_LE(moved(mode), moved(mode - 1) + 1e-6);
  EXPECT_GT(moved(0), 0.2);
}

TEST(FacePlacement, PlacesFollowTurnSizeAndModes) {
  FacePlacement face;
  face.at = vec3(10, 20, 30);
  face.scale = 2;
  const HeadPlaces mean = headPlaces(HeadShape{});
  EXPECT_LT(glm::distance(placesOf(face).noseTip, face.at + 2.f * mean.noseTip), 1e-3f);
  face.modes[0] = 1;
  EXPECT_LT(
      glm::distance(placesOf(face).noseTip, face.at + 2.f * (mean.noseTip + faceModel().moves[0].noseTip)),
      1e-3f);
  const FacePoint& point = faceModel().points[5];
  EXPECT_LT(glm::distance(face.inHead(point), point.place + point.along[0] * point.normal), 1e-5f);
}

}  // namespace
}  // namespace sonoskin
