#include "render/raycaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/render/support/ball_test.h"

namespace sonoskin {
namespace {

using RaycasterTest = BallTest;

TEST_F(RaycasterTest, SphereHasItsClosedFormDepthsNormalsAndSilhouette) {
  cast();
  const auto depths = gl::readFloats(raycaster_.surface().depth(), 1);
  const auto normals = gl::readFloats(raycaster_.surface().colour(), 4);
  const float aspect = 4.0f / 3;
  const glm::mat4 inverse =
      glm::inverse(glm::mat4(camera_.projection(aspect, worldBox(volume_.geometry())) * camera_.view()));
  double covered = 0, worst = 0, worstAngle = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      const std::size_t p = std::size_t(y * kSize.x + x);
      if (depths[p] >= 1) continue;
      ++covered;
      const glm::vec2 ndc = 2.0f * glm::vec2(float(x) + 0.5f, float(y) + 0.5f) / glm::vec2(kSize) - 1.0f;
      const glm::vec4 world = inverse * glm::vec4(ndc, 2 * depths[p] - 1, 1);
      const glm::vec3 arm = glm::vec3(world) / world.w - glm::vec3(kCentre);
      const glm::vec3 normal(normals[4 * p], normals[4 * p + 1], normals[4 * p + 2]);
      worst = std::max(worst, std::abs(double(glm::length(arm)) - kRadius));
      worstAngle = std::max(worstAngle, double(glm::length(glm::normalize(normal) - glm::normalize(arm))));
    }
  EXPECT_LT(worst, 0.05);       // mm; interpolation alone makes spacing^2 / (8 radius) = 0.01
  EXPECT_LT(worstAngle, 0.03);  // radians
  const double sine = kRadius / camera_.distance, tangent = sine / std::sqrt(1 - sine * sine);
  const double radius = 60 * tangent / std::tan(0.5 * glm::radians(double(camera_.fieldOfView)));
  EXPECT_NEAR(std::sqrt(covered / 3.14159265), radius, 0.35);  // pixels
}

TEST_F(RaycasterTest, ThinSheetIsNeverLeaptOver) {
  Geometry g;
  g.dims = glm::ivec3(33);
  for (const int sheet : {6, 7, 8, 9, 15, 16, 17, 31}) {  // around the borders of bricks
    Volume<float> volume(g);
    for (int k = 0; k < 33; ++k)
      for (int i = 0; i < 33; ++i) volume.at(i, sheet, k) = 1;
    volume_.set(std::make_shared<Volume<float>>(volume));
    camera_ = parseCamera("front,azimuth=12,elevation=-7,zoom=4", Beam{}, worldBox(g), 1);
    target_ = gl::Framebuffer({.size = {64, 64}});
    const Lighting lighting = portraitLighting(camera_);
    raycaster_.draw({.volume = volume_, .camera = camera_, .lighting = lighting, .iso = 0.3f}, target_);
    const auto depths = gl::readFloats(raycaster_.surface().depth(), 1);
    EXPECT_EQ(std::count(depths.begin(), depths.end(), 1.0f), 0) << "sheet at " << sheet;
  }
}

// As the thinned volume is stored: the same picture as that of a volume of floats with the same values.
TEST_F(RaycasterTest, BytesAreCastLikeFloats) {
  const Volume<float> exact = ball();
  Volume<std::uint8_t> bytes(exact.geometry);
  Volume<float> floats(exact.geometry);
  for (std::size_t i = 0; i < bytes.data.size(); ++i) {
    bytes.data[i] = std::uint8_t(255 * exact.data[i] + 0.5f);
    floats.data[i] = float(bytes.data[i]) / 255;
  }
  camera_ = parseCamera("front,azimuth=25,elevation=10", Beam{}, worldBox(exact.geometry), 4.0f / 3);
  target_ = gl::Framebuffer({.size = kSize});
  const auto picture = [&](VolumeLook look) {
    raycaster_.draw({.volume = volume_,
                     .camera = camera_,
                     .lighting = portraitLighting(camera_),
                     .look = look,
                     .transfer = amberTransfer(0.5f)},
                    target_);
    return gl::readImage(target_).rgba;
  };
  for (const VolumeLook look : {VolumeLook::surface, VolumeLook::translucent, VolumeLook::maximum}) {
    volume_.set(std::make_shared<Volume<float>>(floats));
    const auto expected = picture(look);
    volume_.set(std::make_shared<Volume<std::uint8_t>>(bytes));
    const auto shown = picture(look);
    int worst = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
      worst = std::max(worst, std::abs(int(shown[i]) - int(expected[i])));
    EXPECT_LE(worst, 3) << int(look);
    EXPECT_GT(*std::ranges::max_element(shown), *std::ranges::min_element(shown) + 60) << "something is seen";
  }
}

TEST_F(RaycasterTest, FewerRaysShowTheSamePictureMoreSoftly) {
  cast(1);
  const Image fine = gl::readImage(target_);
  cast(0.5f);
  const Image coarse = gl::readImage(target_);
  double sum = 0;
  for (std::size_t i = 0; i < fine.rgba.size(); ++i) sum += std::abs(int(fine.rgba[i]) - int(coarse.rgba[i]));
  EXPECT_LT(sum / double(fine.rgba.size()), 3);
  EXPECT_EQ(raycaster_.surface().size(), kSize / 2);
}

// As pictures for a file have them: the ball's edge is no staircase.
TEST_F(RaycasterTest, MoreRaysSmoothTheEdge) {
  const auto greys = [&](float raysPerPixel) {
    cast(raysPerPixel);
    const Image image = gl::readImage(target_);
    std::vector<int> row;  // across the left edge of the ball
    for (int x = 0; x < kSize.x / 2; ++x) row.push_back(image.rgba[std::size_t(4 * (60 * kSize.x + x))]);
    return row;
  };
  const std::vector<int> one = greys(1), four = greys(2);
  EXPECT_EQ(raycaster_.surface().size(), 2 * kSize);
  for (std::size_t x = 0; x < one.size(); ++x) {
    const int least = std::min({one[x], one[x > 0 ? x - 1 : x], one[std::min(x + 1, one.size() - 1)]});
    const int most = std::max({one[x], one[x > 0 ? x - 1 : x], one[std::min(x + 1, one.size() - 1)]});
    EXPECT_GE(four[x], least - 12) << x;
    EXPECT_LE(four[x], most + 12) << x;
  }
}

TEST_F(RaycasterTest, CroppingCutsTheBallOpen) {
  camera_ = parseCamera("front", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
  target_ = gl::Framebuffer({.size = kSize});
  raycaster_.draw({.volume = volume_,
                   .camera = camera_,
                   .lighting = portraitLighting(camera_),
                   .part = {.cropMin = {0, 0.5f, 0}}},
                  target_);
  const auto surfaces = gl::readFloats(raycaster_.surface().colour(), 4);
  const std::size_t middle = std::size_t(60 * kSize.x + 80) * 4;
  const glm::vec3 normal(surfaces[middle], surfaces[middle + 1], surfaces[middle + 2]);
  // The cut's outward normal is -j, and it shows the inside.
  EXPECT_LT(glm::length(normal + glm::vec3(volume_.geometry().direction[1])), 1e-3f);
  EXPECT_LT(surfaces[middle + 3], 0);
}

// What is erased is not there: the ball's front is gone up to a plane through its middle. The mask is coarser than the
// volume, as a volume may be coarser than a mask.
TEST_F(RaycasterTest, ErasedPartsAreNotSeen) {
  cast();
  const std::size_t middle = std::size_t(kSize.y / 2 * kSize.x + kSize.x / 2);
  const auto distance = [&] {
    const float depth = gl::readFloats(raycaster_.surface().depth(), 1)[middle];
    const glm::mat4 projection = camera_.projection(4.0f / 3, worldBox(volume_.geometry()));
    return double(projection[3][2] / (2 * depth - 1 + projection[2][2]));
  };
  EXPECT_NEAR(distance(), double(camera_.distance) - kRadius, 0.3);
  Geometry coarse = volume_.geometry();
  coarse.dims = coarse.dims / 2;
  coarse.spacing *= 2.0;
  coarse.origin = volume_.geometry().toWorld(glm::dvec3(0.5));
  Volume<std::uint8_t> mask(coarse);
  for (int k = 0; k < coarse.dims.z; ++k)
    for (int j = 0; j < coarse.dims.y; ++j)
      for (int i = 0; i < coarse.dims.x; ++i)
        mask.at(i, j, k) = glm::dot(coarse.toWorld({i, j, k}) - kCentre, glm::dvec3(camera_.forward)) < 0;
  GpuMask erased;
  erased.set(mask, Hasher("front").key());
  RaycastInput input{.volume = volume_, .camera = camera_, .lighting = portraitLighting(camera_)};
  input.erased = &erased;
  raycaster_.draw(input, target_);
  EXPECT_NEAR(distance(), double(camera_.distance), 1.2);

  // The translucent look too: nothing at all is left when everything is erased.
  std::fill(mask.data.begin(), mask.data.end(), std::uint8_t(1));
  erased.set(mask, Hasher("all").key());
  input.look = VolumeLook::translucent;
  input.transfer = amberTransfer(0.5f);
  raycaster_.draw(input, target_);
  const auto colours = gl::readFloats(raycaster_.translucent().colour(), 4);
  EXPECT_EQ(colours[4 * middle + 3], 0);
  input.erased = nullptr;
  raycaster_.draw(input, target_);
  EXPECT_GT(gl::readFloats(raycaster_.translucent().colour(), 4)[4 * middle + 3], 0.5f);
}

TEST_F(RaycasterTest, APlaneCutsTheBallOpen) {
  camera_ = parseCamera("front", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
  target_ = gl::Framebuffer({.size = kSize});
  RaycastInput input{.volume = volume_, .camera = camera_, .lighting = portraitLighting(camera_)};
  input.part.clip = clipPlaneThrough(glm::vec3(kCentre) + 3.0f * camera_.forward, camera_.forward);
  raycaster_.draw(input, target_);
  const std::size_t middle = std::size_t(kSize.y / 2 * kSize.x + kSize.x / 2);
  const float depth = gl::readFloats(raycaster_.surface().depth(), 1)[middle];
  const glm::vec2 terms = depthTerms(camera_.projection(4.0f / 3, worldBox(volume_.geometry())));
  EXPECT_NEAR(terms.x / (terms.y - depth), camera_.distance + 3, 0.05);
  const auto surfaces = gl::readFloats(raycaster_.surface().colour(), 4);
  const glm::vec3 normal(surfaces[4 * middle], surfaces[4 * middle + 1], surfaces[4 * middle + 2]);
  EXPECT_LT(glm::length(normal + camera_.forward), 1e-3f);
  EXPECT_LT(surfaces[4 * middle + 3], 0) << "the cut shows the inside";
  // From the other side nothing is cut where the plane lies behind the ball.
  input.part.clip = clipPlaneThrough(glm::vec3(kCentre) - 20.0f * camera_.forward, camera_.forward);
  raycaster_.draw(input, target_);
  const float whole = gl::readFloats(raycaster_.surface().depth(), 1)[middle];
  EXPECT_NEAR(terms.x / (terms.y - whole), camera_.distance - kRadius, 0.05);
}

// A picture that is cast row by row is the one that is cast at once, and comes with the last.
TEST_F(RaycasterTest, RowsAfterRows) {
  camera_ = parseCamera("front", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
  for (const VolumeLook look : {VolumeLook::surface, VolumeLook::translucent, VolumeLook::maximum}) {
    target_ = gl::Framebuffer({.size = kSize});
    RaycastInput input{.volume = volume_,
                       .camera = camera_,
                       .lighting = portraitLighting(camera_),
                       .look = look,
                       .transfer = amberTransfer(0.5f)};
    Raycaster atOnce;
    atOnce.draw(input, target_);
    const Image whole = gl::readImage(target_);
    target_ = gl::Framebuffer({.size = kSize});
    target_.clear({0, 0, 0, 1});
    const Image empty = gl::readImage(target_);
    for (const glm::vec2 rows : {glm::vec2(0, 0.35f), glm::vec2(0.35f, 0.7f), glm::vec2(0.7f, 1)}) {
      EXPECT_EQ(gl::readImage(target_).rgba, empty.rgba);
      input.rows = rows;
      raycaster_.draw(input, target_);
    }
    EXPECT_EQ(gl::readImage(target_).rgba, whole.rgba) << int(look);
  }
}

}  // namespace
}  // namespace sonoskin
