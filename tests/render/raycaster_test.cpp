#include "render/raycaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/gl/read_pixels.h"
#include "render/light_volume.h"
#include "render/mesh_view.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

constexpr float kRadius = 12;
const glm::dvec3 kCentre(31, -20, 55);
constexpr glm::ivec2 kSize(160, 120);

// A ball of radius 12 mm, bright inside, on a turned grid of unequal spacing; iso-value 0.5.
Volume<float> ball() {
  Geometry g;
  g.dims = {48, 70, 40};
  g.spacing = {0.8, 0.5, 1.0};
  const double c = std::cos(0.4), s = std::sin(0.4);
  g.direction = glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1));
  g.origin = kCentre - g.direction * (g.spacing * 0.5 * glm::dvec3(g.dims - 1));
  Volume<float> volume(g);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const double r = glm::length(g.toWorld({i, j, k}) - kCentre);
        volume.at(i, j, k) = float(glm::clamp(0.5 + 0.12 * (kRadius - r), 0.0, 1.0));
      }
  return volume;
}

class RaycasterTest : public GlTest {
 protected:
  RaycasterTest() { volume_.set(std::make_shared<Volume<float>>(ball())); }

  // cast: draws the ball as a surface and keeps the surface buffer.
  void cast(float raysPerPixel = 1) {
    camera_ = parseCamera("front,azimuth=25,elevation=10", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
    target_ = gl::Framebuffer({.size = kSize});
    raycaster_.draw({.volume = volume_,
                     .camera = camera_,
                     .lighting = portraitLighting(camera_),
                     .raysPerPixel = raysPerPixel},
                    target_);
  }
  GpuVolume volume_;
  Camera camera_;
  gl::Framebuffer target_;
  Raycaster raycaster_;
};

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

// What pictures of volumes finer than their voxels rely on: a ball of some twelve pixels a voxel's side.
TEST_F(RaycasterTest, FewerRaysShowTheSameTranslucentPicture) {
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

TEST_F(RaycasterTest, FogHasTheOpacityOfItsThickness) {
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

TEST_F(RaycasterTest, TranslucentBallCastsItsShadowInward) {
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
TEST_F(RaycasterTest, LightBelongsToItsVolume) {
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
TEST_F(RaycasterTest, MaximumIsTheLargestValueAlongEachRay) {
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

// A translucent volume is seen before the mesh and not behind it.
TEST_F(RaycasterTest, ASurfaceWithinEndsTheRays) {
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
TEST_F(RaycasterTest, NoShadowOfWhatIsNotThere) {
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
