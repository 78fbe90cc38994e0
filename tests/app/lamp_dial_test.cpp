#include "app/workspace/lamp_dial.h"

#include <gtest/gtest.h>

#include <random>

namespace sonoskin {
namespace {

Camera someCamera() {
  Camera camera;
  camera.orbit(0.7f, -0.4f);
  camera.roll(0.3f);
  return camera;
}

TEST(LampDial, PlaceAndDirectionAreInverse) {
  const Camera camera = someCamera();
  std::mt19937 engine(5);
  std::normal_distribution<float> number;
  for (int n = 0; n < 300; ++n) {
    const glm::vec3 d = glm::normalize(glm::vec3(number(engine), number(engine), number(engine)));
    const glm::vec2 place = dialPlace(d, camera);
    EXPECT_LE(glm::length(place), kDialEdge + 1e-5f);
    EXPECT_EQ(glm::length(place) > 1, glm::dot(d, camera.forward) > 0) << "behind lies outside the rim";
    EXPECT_GT(glm::dot(dialDirection(place, camera), d), 0.9999f);
  }
}

TEST(LampDial, PassesTheRimWithoutAJump) {
  const Camera camera = someCamera();
  const glm::vec2 toward = glm::normalize(glm::vec2(3, -2));
  glm::vec3 before = dialDirection(0.99f * toward, camera);
  for (float r = 0.99f; r < 1.01f; r += 1e-4f) {
    const glm::vec3 d = dialDirection(r * toward, camera);
    EXPECT_GT(glm::dot(d, before), 0.99f);
    before = d;
  }
}

TEST(LampDial, ItsMiddleIsTheViewerAndItsEdgeIsBehindTheBaby) {
  const Camera camera = someCamera();
  EXPECT_GT(glm::dot(dialDirection({0, 0}, camera), -camera.forward), 0.9999f);
  EXPECT_GT(glm::dot(dialDirection({0.5f, 0}, camera), camera.right()), 0.49f);
  EXPECT_GT(glm::dot(dialDirection({0, 0.5f}, camera), camera.up), 0.49f);
  for (const glm::vec2 far : {glm::vec2(kDialEdge, 0), glm::vec2(-3, 4)})
    EXPECT_GT(glm::dot(dialDirection(far, camera), camera.forward), 0.9999f);
}

}  // namespace
}  // namespace sonoskin
