// Light on surfaces with an atlas of their own: balls.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/skin/atlas_reading.h"
#include "core/skin/beckmann.h"
#include "core/skin/block_diffusion.h"
#include "core/skin/reference_diffusion.h"
#include "core/skin/skin_material.h"
#include "render/gl/read_pixels.h"
#include "render/skin/light_passes.h"
#include "render/skin/skin_view.h"
#include "tests/render/support/gl_test.h"
#include "tests/render/support/skin_plane.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

SkinOptions plainSkin() {
  SkinOptions skin;
  skin.colour = SkinColour::plain;
  skin.mix = skin.gloss = skin.wetness = skin.detail = skin.vernix = skin.translucency = 0;
  return skin;
}

SkinQuality texels(double length) {
  SkinQuality quality;
  quality.texel = length;
  return quality;
}

std::vector<glm::vec4> read(const gl::Texture& map) {
  const auto values = gl::readFloats(map, 4);
  std::vector<glm::vec4> texels;
  for (std::size_t i = 0; i < values.size(); i += 4)
    texels.emplace_back(values[i], values[i + 1], values[i + 2], values[i + 3]);
  return texels;
}

// What leaves each texel.
std::vector<glm::dvec3> leaving(const SkinView& view) {
  const auto first = read(view.light().diffuser().level(0)),
             rest = read(view.light().diffuser().result().map);
  std::vector<glm::dvec3> sum;
  for (std::size_t t = 0; t < first.size(); ++t)
    sum.push_back(literatureSkin().weights[0] * glm::dvec3(first[t]) + glm::dvec3(rest[t]));
  return sum;
}

std::shared_ptr<const SkinSurface> ball(float radius, double texel) {
  return prepareSkin(std::make_shared<const Mesh>(test::icosphere(6, radius, {3, 4, 5})), {0, 0, 1},
                     texels(texel));
}

class SkinLightTest : public GlTest {
 protected:
  SkinLightTest() { context().makeCurrent(); }
  GpuSkin gpu_;
  SkinView view_;
};

// Even light stays even to a thousandth, at the charts' borders too.                         [T9]
TEST_F(SkinLightTest, WhiteFurnaceOnABall) {
  const auto surface = ball(15, 0.3);
  ASSERT_FALSE(surface->pointBased);
  ASSERT_GT(surface->check.charts, 4);
  gpu_.set(surface);
  LightRig rig;
  rig.lights.push_back({.colour = glm::vec3(0), .shadows = false});
  rig.environment[0] = glm::vec3(1 / 0.282095f);
  view_.relight(gpu_, {plainSkin(), {}, rig}, texels(0.3));
  const auto light = leaving(view_);
  double worst = 0, open = 1;
  for (std::size_t t = 0; t < light.size(); ++t) {
    if (!(surface->maps.position[t].w > 0.9f)) continue;
    open = std::min(open, double(surface->maps.occlusion[t].w));
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(light[t][c] - 1));
  }
  // A ball sees the whole sky: what the occlusion is off by is the irradiance's, not the spreading's.
  EXPECT_LT(worst, 1e-3 + 1 - open);
  EXPECT_GT(open, 0.98);
}

// What spreads is not lost: the same power leaves a closed surface as arrives.                [T10]
// Specks that are smaller than texels own none, and are read from the rims around them.
TEST_F(SkinLightTest, SpecksAreLit) {
  Mesh mesh = test::icosphere(3, 10, {0, 0, 0});
  for (int i = 0; i < 20; ++i) {
    const auto first = std::uint32_t(mesh.positions.size());
    const glm::vec3 corner(-20 + 2.07f * float(i), 0, 15);
    for (const glm::vec3& away : {glm::vec3(0), glm::vec3(0.1f, 0, 0), glm::vec3(0, 0.1f, 0)}) {
      mesh.positions.push_back(corner + away);
      mesh.normals.emplace_back(0, 0, 1);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const auto surface = prepareSkin(std::make_shared<const Mesh>(mesh), {0, 0, 1}, texels(0.3));
  ASSERT_FALSE(surface->pointBased);
  gpu_.set(surface);
  LightRig rig;
  rig.lights.push_back({.shadows = false});
  view_.relight(gpu_, {plainSkin(), {}, rig}, texels(0.3));
  const auto light = read(view_.light().diffuser().result().map);
  std::vector<bool> owns(mesh.triangles.size(), false);
  for (std::size_t t = 0; t < light.size(); ++t)
    if (surface->maps.position[t].w == 1) owns[surface->maps.triangle[t]] = true;
  int specks = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    specks += !owns[t];
    for (const glm::vec2& corner : surface->atlas.corners[t])
      for (const std::uint32_t texel : lookBetween(surface->maps.size, corner).texels)
        EXPECT_EQ(light[texel].a > 0, surface->maps.position[texel].w > 0) << t;
  }
  EXPECT_GT(specks, 5);
}

// What earlier lights left behind does not show, whichever light or setting changes.
TEST_F(SkinLightTest, ChangesAreAsIfDrawnAnew) {
  const auto surface = ball(12, 0.4);
  gpu_.set(surface);
  SkinLook look;
  look.lights = makeLightRig({}, {}, gpu_.box());
  ASSERT_EQ(look.lights.lights.size(), 3u);
  view_.relight(gpu_, look, lightQuality());
  std::vector<glm::vec4> before = read(view_.light().diffuser().result().map);
  const std::vector<std::function<void()>> changes{
      [&] { look.lights.lights[0].position = glm::normalize(glm::vec3(1, 0.2f, -0.4f)); },
      [&] { look.lights.lights[2].softness = 0.3f; },
      [&] { look.lights.lights[1].colour *= 2; },
      [&] { look.lights.lights[2].shadows = false; },
      [&] { look.skin.melanin *= 3; },
      [&] {
        look.lights.lights[0].kind = LightKind::inside, look.lights.lights[0].position = glm::vec3(3, 4, 7);
      },
      [&] { look.skin.density *= 0.5; },
      [&] { look.lights.lights.pop_back(); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    changes[i]();
    view_.relight(gpu_, look, lightQuality());
    SkinView fresh;
    fresh.relight(gpu_, look, lightQuality());
    const std::vector<glm::vec4> after = read(view_.light().diffuser().result().map);
    EXPECT_EQ(after, read(fresh.light().diffuser().result().map)) << i;
    EXPECT_NE(after, before) << i;
    before = after;
  }
}

TEST_F(SkinLightTest, KeepsThePower) {
  const auto surface = ball(15, 0.3);
  gpu_.set(surface);
  std::vector<glm::vec4> irradiance;
  for (std::size_t t = 0; t < surface->maps.position.size(); ++t) {
    const bool covered = surface->maps.position[t].w > 0;
    irradiance.emplace_back(glm::vec3(covered ? std::max(0.f, surface->maps.normal[t].x) : 0.f),
                            covered ? 1.f : 0.f);
  }
  view_.light().spread(gpu_, plainSkin(), irradiance);
  const auto light = leaving(view_);
  glm::dvec3 out(0);
  double in = 0;
  for (std::size_t t = 0; t < light.size(); ++t) {
    if (!(surface->maps.position[t].w > 0.9f)) continue;
    const double area = double(surface->maps.stretch[t].x) * double(surface->maps.stretch[t].y);
    out += area * light[t];
    in += area * double(irradiance[t].r);
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(out[c] / in, 1, 0.005) << c;
}

// Light beyond the terminator of a ball of 20 mm: the table T6.
TEST_F(SkinLightTest, TerminatorOfABall) {
  const auto surface = ball(20, 0.15);
  gpu_.set(surface);
  LightRig rig;
  const glm::vec3 from = glm::normalize(glm::vec3(0.8f, 0.3f, 0.5f));
  rig.lights.push_back({.position = from, .colour = glm::vec3(1), .shadows = false});
  view_.relight(gpu_, {plainSkin(), {}, rig}, texels(0.15));
  const auto light = leaving(view_);
  for (const test::SkinValue& row : test::kSphere20) {
    glm::dvec3 sum(0);
    double count = 0;
    for (std::size_t t = 0; t < light.size(); ++t) {
      const glm::vec4& p = surface->maps.position[t];
      if (!(p.w > 0.9f)) continue;
      const glm::vec3 out = glm::normalize(glm::vec3(p) - glm::vec3(3, 4, 5));
      const double angle = glm::degrees(std::acos(glm::clamp(double(glm::dot(out, from)), -1.0, 1.0)));
      if (std::abs(angle - row.at) > (row.at == 0 ? 2 : 0.25)) continue;
      sum += light[t];
      ++count;
    }
    ASSERT_GT(count, 20);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / count, row.light[c], 0.003) << row.at << " " << c;
  }
}

// What the window spreads in the background.
PointsLight refined(const EnteringLight& entering, const std::shared_ptr<const SkinSurface>& surface,
                    BlockDiffusion& kept) {
  return spreadByPoints(surface, entering.material().diffusion, entering.look().skin.thinModel,
                        {gl::readTexels(entering.irradiance()), gl::readTexels(entering.thinness())}, kept);
}

// Light from point to point that comes later takes the place of the blurs, is what finished pictures have, and stays until
// the light changes.
TEST_F(SkinLightTest, RefinedLightStaysUntilTheLightChanges) {
  const auto surface = ball(10, 0.3);
  GpuSkin gpu;
  gpu.set(surface);
  const auto lit = [](const glm::vec3& direction) {
    LightRig rig;
    rig.lights.push_back({.position = glm::normalize(direction), .colour = glm::vec3(1), .shadows = false});
    return SkinLook{plainSkin(), {}, rig};
  };
  const SkinLook look = lit({1, 0, 1});
  SkinQuality finished;
  finished.diffusion = DiffusionMethod::points;
  SkinView view, picture;
  picture.relight(gpu, look, finished);
  view.relight(gpu, look, {});
  EXPECT_FALSE(view.light().refined());
  const auto blurred = read(view.light().diffuser().result().map);
  EXPECT_NE(blurred, read(picture.light().diffuser().result().map));
  EXPECT_EQ(view.light().diffuser().result().firstWeight, picture.light().diffuser().result().firstWeight);

  BlockDiffusion kept;
  view.light().take(gpu, refined(view.light().entering(), surface, kept));
  EXPECT_TRUE(view.light().refined());
  EXPECT_EQ(read(view.light().diffuser().result().map), read(picture.light().diffuser().result().map));
  view.relight(gpu, look, {});
  EXPECT_TRUE(view.light().refined()) << "no blurs in place of what is better";
  view.relight(gpu, look, finished);
  EXPECT_EQ(read(view.light().diffuser().result().map), read(picture.light().diffuser().result().map))
      << "kept";

  view.relight(gpu, lit({0, 1, 1}), {});
  EXPECT_FALSE(view.light().refined());
  view.relight(gpu, look, {});
  EXPECT_EQ(read(view.light().diffuser().result().map), blurred);
}

// A picture that gives memory back on the way is the same picture.
TEST_F(SkinLightTest, LightForOnePictureIsTheSameAndKeepsLess) {
  const auto surface = ball(10, 0.3);
  SkinQuality finished;
  finished.diffusion = DiffusionMethod::points;
  SkinLook look{plainSkin(), {}, {}};
  look.lights.lights.push_back({.position = glm::normalize(glm::vec3(1, 0, 1)), .colour = glm::vec3(1)});
  const auto draw = [&](bool once, std::size_t& bytes) {
    GpuSkin gpu;
    gpu.set(surface);
    SkinView view;
    if (once)
      view.relightOnce(gpu, look, finished);
    else
      view.relight(gpu, look, finished);
    const Camera camera = lookAlong({0, 0, -1}, {0, 1, 0}, gpu.box(), 1);
    const gl::Framebuffer picture({.size = {200, 200}});
    view.draw({.surface = gpu, .camera = camera, .look = look, .quality = finished, .supersampling = 2},
              picture);
    bytes = view.mapBytes();
    return gl::readImage(picture).rgba;
  };
  std::size_t all = 0, kept = 0;
  const auto expected = draw(false, all);
  EXPECT_EQ(draw(true, kept), expected);
  // Position, normal, open sky and stretch, and the light that enters.
  constexpr std::size_t kTexel = 16 + 8 + 8 + 4 + 8;
  EXPECT_GE(all, kept + kTexel * std::size_t(surface->maps.size.x) * std::size_t(surface->maps.size.y));
}

// Where the first Gaussian is blurred too, level 0 is no longer what has entered: that is what points spread.
TEST_F(SkinLightTest, WhatIsRefinedIsTheLightThatEntersWideSkinToo) {
  const auto surface = ball(10, 0.3);
  GpuSkin gpu;
  gpu.set(surface);
  SkinLook look{plainSkin(), {}, {}};
  look.skin.width = 2;
  look.lights.lights.push_back({.position = glm::normalize(glm::vec3(1, 0, 1)), .shadows = false});
  SkinQuality finished;
  finished.diffusion = DiffusionMethod::points;
  SkinView view, picture;
  picture.relight(gpu, look, finished);
  view.relight(gpu, look, {});
  const auto entered = gl::readTexels(view.light().entering().irradiance());
  EXPECT_NE(entered, gl::readTexels(view.light().diffuser().level(0)));
  BlockDiffusion kept;
  view.light().take(gpu, refined(view.light().entering(), surface, kept));
  EXPECT_EQ(read(view.light().diffuser().result().map), read(picture.light().diffuser().result().map));
}

// The reference is better than points, holds all six Gaussians, and stays.
TEST_F(SkinLightTest, TheReferenceStandsAboveTheOthers) {
  const auto surface = ball(10, 0.5);
  GpuSkin gpu;
  gpu.set(surface);
  SkinLook look{plainSkin(), {}, {}};
  look.lights.lights.push_back({.position = glm::normalize(glm::vec3(1, 0, 1)), .shadows = false});
  SkinQuality exact;
  exact.diffusion = DiffusionMethod::reference;
  SkinView view;
  view.relight(gpu, look, exact);
  const auto expected =
      referenceDiffusion(*surface, look.skin, gl::readTexels(view.light().entering().irradiance()));
  const auto found = gl::readTexels(view.light().diffuser().result().map);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (int c = 0; c < 4; ++c) ASSERT_NEAR(found[i][c], expected[i][c], 1e-3f * expected[i][c] + 1e-6f) << i;
  EXPECT_EQ(view.light().diffuser().result().firstWeight, glm::vec3(0));
  view.relight(gpu, look, {});
  EXPECT_EQ(gl::readTexels(view.light().diffuser().result().map), found) << "kept";
}

}  // namespace
}  // namespace sonoskin
