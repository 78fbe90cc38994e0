#include "render/camera.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace sonoskin {
namespace {

const Box kBox{{-20, -30, -40}, {60, 10, 20}};

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-4f) {
  EXPECT_LT(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

glm::vec3 project(const Camera& camera, float aspect, const glm::vec3& p) {
  const glm::vec4 clip = camera.projection(aspect, kBox) * camera.view() * glm::vec4(p, 1);
  return glm::vec3(clip) / clip.w;
}

TEST(Camera, SeesTheWholeBoxAndFillsThePicture) {
  for (const char* preset : {"probe", "front", "back", "left", "right", "top", "bottom", "portrait"})
    for (const float aspect : {0.5f, 1.0f, 1.7f}) {
      const Camera camera = parseCamera(preset, Beam{}, kBox, aspect);
      float widest = 0;
      for (int c = 0; c < 8; ++c) {
        const glm::vec3 corner(c & 1 ? kBox.max.x : kBox.min.x, c & 2 ? kBox.max.y : kBox.min.y,
                               c & 4 ? kBox.max.z : kBox.min.z);
        const glm::vec3 p = project(camera, aspect, corner);
        widest = std::max({widest, std::abs(p.x), std::abs(p.y)});
        EXPECT_LE(std::abs(p.z), 1);
      }
      EXPECT_LT(widest, 1.0f) << preset;
      EXPECT_GT(widest, 0.9f) << preset;
    }
}

TEST(Camera, ProbeLooksAlongTheBeamWithItsUpUpward) {
  Beam beam;
  beam.axis = {0, 0, 1};
  beam.up = {0, 1, 0};
  const Camera camera = parseCamera("probe", beam, kBox, 1);
  expectNear(camera.forward, {0, 0, 1});
  expectNear(camera.up, {0, 1, 0});
  expectNear(parseCamera("", beam, kBox, 1).forward, {0, 0, 1});
}

TEST(Camera, IsFiniteWhateverIsUp) {
  const Box box{{-10, -20, -30}, {10, 20, 30}};
  const std::vector<glm::vec3> points{{0, 0, 0}, {5, 5, 5}};
  for (const glm::vec3& forward :
       {glm::vec3(0, 1, 0), glm::vec3(0, 0, -1), glm::normalize(glm::vec3(1, 2, 3))})
    for (const glm::vec3& up : {forward, -forward, glm::vec3(0), 1e-20f * forward})
      for (const Camera& camera : {lookAlong(forward, up, box, 1.5f), lookAtAll(forward, up, points, 1.5f)}) {
        EXPECT_NEAR(glm::length(camera.up), 1, 1e-5f);
        EXPECT_NEAR(glm::dot(camera.up, camera.forward), 0, 1e-5f);
        EXPECT_TRUE(std::isfinite(camera.distance) && camera.distance > 0);
      }
}

TEST(Camera, FrontSeesThePatientsLeftOnTheRight) {
  const Camera camera = parseCamera("front", Beam{}, kBox, 1);
  expectNear(camera.right(), {1, 0, 0});
  EXPECT_LT(camera.eye().y, kBox.min.y);
}

TEST(Camera, AzimuthMovesTheEyeToTheRightAndElevationUp) {
  const Camera front = parseCamera("front", Beam{}, kBox, 1);
  const Camera right = parseCamera("front,azimuth=90", Beam{}, kBox, 1);
  expectNear((right.eye() - right.target) / right.distance, front.right());
  const Camera above = parseCamera("front,elevation=30", Beam{}, kBox, 1);
  expectNear(above.forward, glm::vec3(0, std::sqrt(0.75f), -0.5f));
  EXPECT_GT(above.up.z, 0);
}

TEST(Camera, RollTurnsThePictureClockwise) {
  const Camera camera = parseCamera("front,roll=90", Beam{}, kBox, 1);
  // What was on top (+z) is now on the right.
  expectNear(camera.right(), {0, 0, 1});
}

TEST(Camera, OrbitThereAndBackIsTheIdentityAndKeepsTheFrameOrthonormal) {
  Camera camera = parseCamera("probe,azimuth=20", Beam{}, kBox, 1);
  const Camera before = camera;
  camera.orbit(0.7f, 0);
  camera.orbit(0, -0.4f);
  EXPECT_NEAR(glm::length(camera.forward), 1, 1e-5);
  EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0, 1e-5);
  camera.orbit(0, 0.4f);
  camera.orbit(-0.7f, 0);
  expectNear(camera.forward, before.forward);
  expectNear(camera.up, before.up);
}

TEST(Camera, ItsWordsAreExactlyTheSameCamera) {
  Camera camera = parseCamera("probe,azimuth=20,elevation=-7,roll=3,zoom=1.3", Beam{}, kBox, 1);
  camera.pan({30, -20}, 400);
  const Camera same = parseCamera(cameraWords(camera), Beam{}, kBox, 2);
  expectNear(same.target, camera.target);
  expectNear(same.forward, camera.forward);
  expectNear(same.up, camera.up);
  EXPECT_FLOAT_EQ(same.distance, camera.distance);
  for (const char* wrong :
       {"target=1:2", "target=1:2:x", "up=0:0:0", "forward=0:0:0", "distance=0", "distance=nan"})
    EXPECT_THROW(parseCamera(wrong, Beam{}, kBox, 1), Error) << wrong;
}

TEST(Camera, PanMovesThePictureByThatManyPixels) {
  Camera camera = parseCamera("front", Beam{}, kBox, 1);
  const glm::vec3 p = camera.target;
  camera.pan({30, -20}, 400);
  const glm::vec3 ndc = project(camera, 1, p);
  EXPECT_NEAR(ndc.x * 200, 30, 0.01);
  EXPECT_NEAR(ndc.y * 200, -20, 0.01);
}

TEST(Camera, LookAtAllSeesEveryPointAndComesAsNearAsItCan) {
  const std::vector<glm::vec3> points{{3, -2, 1}, {40, 8, -3}, {12, 30, 9}, {-7, 4, -20}, {11, 12, 25}};
  for (const float aspect : {0.3f, 1.f, 1.6f}) {
    const Camera camera = lookAtAll({0.3f, 1, -0.2f}, {1, 0.2f, 0.3f}, points, aspect);
    const Box box = boundingBox(points);
    float widest = 0, least = 1, most = -1;
    for (const glm::vec3& p : points) {
      const glm::vec4 clip = camera.projection(aspect, box) * camera.view() * glm::vec4(p, 1);
      const glm::vec2 at = glm::vec2(clip) / clip.w;
      widest = std::max({widest, std::abs(at.x), std::abs(at.y)});
      least = std::min(least, at.x);
      most = std::max(most, at.x);
    }
    EXPECT_LT(widest, 0.99f);
    EXPECT_GT(widest, 0.93f);
    if (aspect < 0.5f) {
      EXPECT_NEAR(least, -most, 0.01f) << "in the middle";
    }
  }
}

TEST(Camera, FaceIsTheOneThatIsGivenOrTheProbes) {
  Camera face = parseCamera("left", Beam{}, kBox, 1);
  expectNear(parseCamera("face", Beam{}, kBox, 1, &face).forward, face.forward);
  expectNear(parseCamera("face", Beam{}, kBox, 1).forward, parseCamera("probe", Beam{}, kBox, 1).forward);
  EXPECT_LT(parseCamera("face,zoom=2", Beam{}, kBox, 1, &face).distance, face.distance);
}

TEST(Camera, RefusesWhatItDoesNotKnow) {
  for (const char* text :
       {"sideways", "azimuth", "azimuth=", "azimuth=3x", "zoom=0", "zoom=-1", "front,back"})
    EXPECT_THROW(parseCamera(text, Beam{}, kBox, 1), Error) << text;
}

TEST(Camera, WorldBoxHoldsATurnedVolume) {
  Geometry g;
  g.dims = {11, 21, 31};
  g.spacing = {1, 2, 0.5};
  g.origin = {5, 6, 7};
  g.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  const Box box = worldBox(g);
  expectNear(box.min, {-35, 6, 7});
  expectNear(box.max, {5, 16, 22});
}

}  // namespace
}  // namespace sonoskin
