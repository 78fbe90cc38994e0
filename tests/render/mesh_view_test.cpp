#include "render/mesh_view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/gl/read_pixels.h"
#include "render/parts_mesh.h"
#include "render/pictures.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

class MeshViewTest : public GlTest {
 protected:
  Image draw(MeshLook look, const std::string& camera = "front") {
    PictureOptions options;
    options.size = {160, 120};
    options.camera = camera;
    return pictureOfMesh(context(), std::make_shared<Mesh>(sphereMesh({5, -3, 8}, 10)), look, options);
  }
  // Luma of a pixel, 0 to 255.
  static double luma(const Image& image, int x, int y) {
    const std::uint8_t* p = &image.rgba[std::size_t(4 * (y * image.width + x))];
    return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
  }
};

TEST_F(MeshViewTest, SilhouetteOfASphereHasTheRadiusOfItsTangentCone) {
  const Image image = draw(MeshLook::clay);
  const Camera camera = parseCamera("front", Beam{}, Box{{-5, -13, -2}, {15, 7, 18}}, 4.0f / 3);
  // A sphere at distance d shows the radius tan(asin(r / d)) on the plane at unit distance.
  const double sine = 10.0 / camera.distance, tangent = sine / std::sqrt(1 - sine * sine);
  const double expected = 60 * tangent / std::tan(0.5 * glm::radians(double(camera.fieldOfView)));
  double covered = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) covered += luma(image, x, y) > 66;
  EXPECT_NEAR(std::sqrt(covered / 3.14159265), expected, 0.5);
}

TEST_F(MeshViewTest, LightComesFromAboveAndTheLeft) {
  const Image image = draw(MeshLook::clay);
  EXPECT_GT(luma(image, 80 - 22, 60 - 22), luma(image, 80 + 22, 60 + 22) + 60);
}

TEST_F(MeshViewTest, SkinIsRedderThanClay) {
  const Image skin = draw(MeshLook::skin), clay = draw(MeshLook::clay);
  const std::size_t middle = std::size_t(4 * (60 * 160 + 80));
  EXPECT_GT(skin.rgba[middle] - skin.rgba[middle + 2], clay.rgba[middle] - clay.rgba[middle + 2] + 20);
}

TEST_F(MeshViewTest, WhatWasNotMeasuredIsGreyedWhereAskedFor) {
  Mesh mesh = sphereMesh({5, -3, 8}, 10);
  for (const glm::vec3& p : mesh.positions) mesh.measured.push_back(p.x > 5 ? 0.f : 1.f);
  PictureOptions options;
  options.size = {160, 120};
  options.camera = "front";
  const auto picture = [&] {
    return pictureOfMesh(context(), std::make_shared<Mesh>(mesh), MeshLook::skin, options);
  };
  const auto redness = [](const Image& image, int x) {
    const std::uint8_t* p = &image.rgba[std::size_t(4 * (60 * image.width + x))];
    return p[0] - p[2];
  };
  const Image plain = picture();
  options.unseenShade = 1;
  const Image marked = picture();
  // Seen from the front, the left of the baby (x > 5) is on the right.
  EXPECT_EQ(redness(marked, 80 - 20), redness(plain, 80 - 20));
  EXPECT_LT(redness(marked, 80 + 20), redness(plain, 80 + 20) - 20);
}

// A ball in two parts: blue in front, the other one dim; no third colour between them.
TEST_F(MeshViewTest, PartsHaveTheirColours) {
  const Mesh ball = sphereMesh({5, -3, 8}, 10);
  std::vector<std::uint32_t> part;
  for (const Triangle& t : ball.triangles) part.push_back(ball.positions[t[0]].x < 5 ? 0 : 1);
  PictureOptions options;
  options.size = {160, 120};
  options.camera = "front";
  const auto draw = [&](bool dimmed) {
    const Mesh shown = makePartsMesh(ball, part, {{1, false}, {2, dimmed}});
    return pictureOfMesh(context(), std::make_shared<Mesh>(shown), MeshLook::parts, options);
  };
  const Image bright = draw(false), dim = draw(true);
  int blue = 0, green = 0, dimmer = 0, other = 0;
  for (std::size_t i = 0; i < bright.rgba.size(); i += 4) {
    const int r = bright.rgba[i], g = bright.rgba[i + 1], b = bright.rgba[i + 2];
    const int spread = std::max({r, g, b}) - std::min({r, g, b});
    if (spread < 60) continue;
    blue += b > g + 20 && g > r;
    green += g > r + 20 && g > b;
    other += r > g || (g > b && b > g - 15);
    dimmer += g > b && dim.rgba[i + 1] < g - 30;
  }
  EXPECT_GT(blue, 1000);
  EXPECT_GT(green, 1000);
  EXPECT_LT(other, 150);
  EXPECT_GT(dimmer, green * 8 / 10);
}

TEST_F(MeshViewTest, SamePictureAgain) { EXPECT_EQ(draw(MeshLook::skin).rgba, draw(MeshLook::skin).rgba); }

TEST_F(MeshViewTest, OsMesaShowsTheSamePicture) {
  const Image egl = draw(MeshLook::skin);
  const auto osMesa = gl::makeOffscreenContext(gl::Backend::osmesa);
  PictureOptions options;
  options.size = {160, 120};
  options.camera = "front";
  const Image other =
      pictureOfMesh(*osMesa, std::make_shared<Mesh>(sphereMesh({5, -3, 8}, 10)), MeshLook::skin, options);
  double sum = 0;
  for (std::size_t i = 0; i < egl.rgba.size(); ++i) sum += std::abs(int(egl.rgba[i]) - int(other.rgba[i]));
  EXPECT_LT(sum / double(egl.rgba.size()), 0.05);
}

TEST_F(MeshViewTest, EmptyMeshShowsTheBackgroundOnly) {
  PictureOptions options;
  options.size = {64, 64};
  const Image image = pictureOfMesh(context(), std::make_shared<Mesh>(), MeshLook::clay, options);
  EXPECT_LT(luma(image, 32, 32), 60);
}

TEST_F(MeshViewTest, SphereCastsItsShadowOnASheetBehind) {
  // A sheet seen from the front, with a ball before it on the light's side.
  Mesh mesh = sphereMesh({-8, 20, 8}, 6);
  const auto first = std::uint32_t(mesh.positions.size());
  for (const glm::vec3 corner : {glm::vec3(-30, 30, -30), {30, 30, -30}, {30, 30, 30}, {-30, 30, 30}}) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back({0, -1, 0});
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
  PictureOptions options;
  options.size = {200, 200};
  options.camera = "front";
  const Image image = pictureOfMesh(context(), std::make_shared<Mesh>(mesh), MeshLook::clay, options);
  // The shadow falls opposite to the light: to the right of and below the ball.
  EXPECT_GT(luma(image, 150, 40), luma(image, 106, 102) + 40);
}

}  // namespace
}  // namespace sonoskin
