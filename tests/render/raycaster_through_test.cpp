// What rays gather on their way through a volume: translucent looks and the maximum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/light_volume.h"
#include "render/mesh_view.h"
#include "tests/render/support/ball_test.h"

namespace sonoskin {
namespace {

using RaycasterThroughTest = BallTest;

// What pictures of volumes finer than their voxels rely on: a ball of some twelve pixels a voxel's side.
TEST_F(RaycasterThroughTest, FewerRaysShowTheSameTranslucentPicture) {
  const auto picture = [&](float raysPerPixel) {
    camera_ = parseCamera("front,azimuth=25", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
    target_ = gl::Framebuffer({.size = 4 * kSize});
    raycaster_.draw({.volume = volume_,
                     .camera = camera_,
                     .lighting = portraitLighting(camera_),
                     .look = VolumeLook::translucent,
                     .transfer = amberTransfer(0.5f),
                     .raysPerPixel = raysPerPixel},
                    target_);
    return gl::readImage(target_);
  };
  const Image fine = picture(1), coarse = picture(0.5f);
  EXPECT_EQ(raycaster_.translucent().size(), 2 * kSize);
  double sum = 0, light = 0;
  for (std::size_t i = 0; i < fine.rgba.size(); ++i) {
    sum += std::abs(int(fine.rgba[i]) - int(coarse.rgba[i]));
    light += i % 4 == 0 && fine.rgba[i] > 100;
  }
  EXPECT_GT(light, 0.1 * double(fine.rgba.size() / 4)) << "nothing is seen";
  EXPECT_LT(sum / double(fine.rgba.size()), 0.5);
}

TEST_F(RaycasterThroughTest, FogHasTheOpacityOfItsThickness) {
  Geometry g;
  g.dims = glm::ivec3(40);
  volume_.set(std::make_shared<Volume<float>>(Volume<float>(g, 1.0f)));
  camera_ = parseCamera("front", Beam{}, worldBox(g), 1);
  target_ = gl::Framebuffer({.size = {65, 65}});
  raycaster_.draw({.volume = volume_,
                   .camera = camera_,
                   .lighting = portraitLighting(camera_),
                   .look = VolumeLook::translucent,
                   .transfer = {{{0, glm::vec3(1), 0}, {1, glm::vec3(1), 0.008f}}}},
                  target_);
  const auto colours = gl::readFloats(raycaster_.translucent().colour(), 4);
  double opacity = 0;  // averaged over the starts of the rays
  for (int y = 28; y < 37; ++y)
    for (int x = 28; x < 37; ++x) opacity += double(colours[std::size_t(4 * (y * 65 + x) + 3)]) / 81;
  EXPECT_NEAR(opacity, 1 - std::exp(-39 * extinctionPerMm(0.008f, worldDiagonal(g))), 0.006);
}

TEST_F(RaycasterThroughTest, TranslucentBallCastsItsShadowInward) {
  camera_ = parseCamera("front", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
  target_ = gl::Framebuffer({.size = kSize});
  raycaster_.draw({.volume = volume_,
                   .camera = camera_,
                   .lighting = portraitLighting(camera_),
                   .look = VolumeLook::translucent,
                   .transfer = amberTransfer(0.5f)},
                  target_);
  const Image image = gl::readImage(target_);
  const auto red = [&](int x, int y) { return int(image.rgba[std::size_t(4 * (y * kSize.x + x))]); };
  EXPECT_GT(red(80 - 18, 60 - 18), red(80 + 18, 60 + 18) + 30);
}

// Drivers give the name of a texture that is gone to the next one: light that was computed for one volume is not another's.
TEST_F(RaycasterThroughTest, LightBelongsToItsVolume) {
  Geometry g;
  g.dims = glm::ivec3(40);
  camera_ = parseCamera("front", Beam{}, worldBox(g), 1);
  const auto draw = [&](Raycaster& raycaster) {
    raycaster.draw({.volume = volume_,
                    .camera = camera_,
                    .lighting = portraitLighting(camera_),
                    .look = VolumeLook::translucent,
                    .transfer = amberTransfer(0.5f)},
                   target_);
    return gl::readImage(target_).rgba;
  };
  const auto withWall = [&](int from, int to) {
    Volume<float> volume(g);
    for (int k = 0; k < 40; ++k)
      for (int j = 0; j < 40; ++j)
        for (int i = from; i < to; ++i) volume.at(i, j, k) = 0.6f;
    return std::make_shared<Volume<float>>(volume);
  };
  target_ = gl::Framebuffer({.size = {65, 65}});
  volume_.set(withWall(0, 40));
  draw(raycaster_);
  for (const int turns : {1, 2, 3}) {  // so that the name comes back whatever the driver's order
    for (int i = 0; i < turns; ++i) volume_.set(withWall(10 + i + turns, 14 + i + turns));
    Raycaster fresh;
    EXPECT_EQ(draw(raycaster_), draw(fresh)) << turns;
  }
}

// Every ray has the largest value that lies on it, whatever bricks it leaps over.
TEST_F(RaycasterThroughTest, MaximumIsTheLargestValueAlongEachRay) {
  Geometry g;
  g.dims = glm::ivec3(33);
  Volume<float> volume(g);
  for (int k = 0; k < 33; ++k)
    for (int j = 0; j < 33; ++j)
      for (int i = 0; i < 33; ++i) volume.at(i, j, k) = 0.1f + 0.02f * float((7 * i + 3 * k) % 5);
  for (int k = 0; k < 33; ++k) {
    for (int i = 0; i < 33; ++i) volume.at(i, 4, k) = volume.at(i, 5, k) = 0.4f;  // a dim sheet in front
    for (int j = 20; j < 24; ++j)
      for (int i = 10; i < 20; ++i) volume.at(i, j, k) = 0.8f;  // a bright bar behind
  }
  volume_.set(std::make_shared<Volume<float>>(volume));
  camera_ = parseCamera("front,zoom=1.5", Beam{}, worldBox(g), 1);
  target_ = gl::Framebuffer({.size = {64, 64}});
  RaycastInput input{.volume = volume_,
                     .camera = camera_,
                     .lighting = portraitLighting(camera_),
                     .look = VolumeLook::maximum};
  raycaster_.draw(input, target_);
  const auto seen = gl::readFloats(raycaster_.translucent().colour(), 4);
  const auto at = [&](int x, int y) { return seen[std::size_t(4 * (64 * y + x) + 3)]; };
  EXPECT_NEAR(at(32, 32), 0.8, 0.01);  // behind the sheet
  EXPECT_NEAR(at(50, 32), 0.4, 0.01);  // beside the bar
  // The window: what is below it is black.
  input.window = {0.6f, 0.2f};
  raycaster_.draw(input, target_);
  const auto windowed = gl::readFloats(raycaster_.translucent().colour(), 4);
  EXPECT_EQ(windowed[std::size_t(4 * (64 * 32 + 50) + 3)], 0);
  EXPECT_NEAR(windowed[std::size_t(4 * (64 * 32 + 32) + 3)], 1, 0.01);
}

// A translucent volume is seen before the mesh and not behind it.
TEST_F(RaycasterThroughTest, ASurfaceWithinEndsTheRays) {
  Geometry g;
  g.dims = glm::ivec3(40);
  volume_.set(std::make_shared<Volume<float>>(Volume<float>(g, 1.0f)));
  camera_ = parseCamera("front", Beam{}, worldBox(g), 1);
  const float half = 19.5f;
  Mesh plane;
  plane.positions = {{-60, half, -60}, {99, half, -60}, {99, half, 99}, {-60, half, 99}};
  plane.normals.assign(4, {0, -1, 0});
  plane.triangles = {{0, 1, 2}, {0, 2, 3}};
  GpuMesh mesh;
  mesh.set(std::make_shared<Mesh>(plane));
  target_ = gl::Framebuffer({.size = {64, 64}});
  const gl::Framebuffer picture({.size = {64, 64}});
  MeshView view;
  view.draw({.mesh = mesh, .camera = camera_, .lighting = portraitLighting(camera_)}, picture);
  const SurfaceBehind behind{view.buffer(), picture};
  RaycastInput input{.volume = volume_,
                     .camera = camera_,
                     .lighting = portraitLighting(camera_),
                     .look = VolumeLook::translucent,
                     .transfer = {{{0, glm::vec3(1), 0}, {1, glm::vec3(0.05f), 0.008f}}}};
  const auto opacity = [&] {
    raycaster_.draw(input, target_);
    const auto colours = gl::readFloats(raycaster_.translucent().colour(), 4);
    double sum = 0;
    for (int y = 28; y < 36; ++y)
      for (int x = 28; x < 36; ++x) sum += double(colours[std::size_t(4 * (y * 64 + x) + 3)]) / 64;
    return sum;
  };
  const double perMm = double(extinctionPerMm(0.008f, worldDiagonal(g)));
  EXPECT_NEAR(opacity(), 1 - std::exp(-39 * perMm), 0.01);
  const Image alone = gl::readImage(target_);
  input.behind = &behind;
  EXPECT_NEAR(opacity(), 1 - std::exp(-19.5 * perMm), 0.01);
  const Image both = gl::readImage(target_), surface = gl::readImage(picture);
  const std::size_t middle = 4 * (32 * 64 + 32);
  EXPECT_GT(int(surface.rgba[middle]), int(alone.rgba[middle]) + 20);
  EXPECT_GT(int(both.rgba[middle]), int(alone.rgba[middle])) << "the mesh shines through";
}

// What is cut off casts no shadow either.
TEST_F(RaycasterThroughTest, NoShadowOfWhatIsNotThere) {
  camera_ = parseCamera("front", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
  target_ = gl::Framebuffer({.size = kSize});
  RaycastInput input{.volume = volume_,
                     .camera = camera_,
                     .lighting = portraitLighting(camera_),
                     .look = VolumeLook::translucent,
                     .transfer = amberTransfer(0.5f)};
  const auto light = [&] {
    raycaster_.draw(input, target_);
    const Image image = gl::readImage(target_);
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i];
    return sum;
  };
  input.part.clip = clipPlaneThrough(glm::vec3(kCentre), camera_.forward);
  const double cut = light();
  input.shadows = false;
  const double shadowless = light();
  EXPECT_GT(cut, 0.8 * shadowless) << "the cut faces the light";
  input.part.clip = {};
  EXPECT_GT(shadowless, 0);
  const double round = light();
  input.shadows = true;
  EXPECT_LT(light(), 0.95 * round) << "the far side of the whole ball lies in its shadow";
}

}  // namespace
}  // namespace sonoskin
