#include "render/skin/skin_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/skin/gaussian_sum.h"
#include "render/gl/read_pixels.h"
#include "render/skin/light_passes.h"
#include "tests/render/support/gl_test.h"
#include "tests/render/support/skin_plane.h"

namespace sonoskin {
namespace {

constexpr float kTexel = 0.15f;

SkinOptions plainSkin() {
  SkinOptions skin;
  skin.colour = SkinColour::plain;
  skin.mix = skin.gloss = skin.wetness = skin.detail = skin.vernix = skin.translucency = 0;
  return skin;
}

// Far, white, from `direction`; nothing else.
LightRig oneLight(const glm::vec3& direction) {
  LightRig rig;
  rig.lights.push_back({.position = glm::normalize(direction), .colour = glm::vec3(1), .shadows = false});
  return rig;
}

class SkinViewTest : public GlTest {
 protected:
  SkinViewTest() { context().makeCurrent(); }

  // What leaves the skin at a place of the plane for a given irradiance.
  glm::dvec3 leaving(const SkinSurface& plane, const SkinView& view, double x, double y) const {
    const glm::ivec2 texel((glm::dvec2(x, y) / double(kTexel)) + glm::dvec2(plane.maps.size) * 0.5);
    const auto at = [&](const gl::Texture& map) {
      const auto values = gl::readFloats(map, 4);
      const std::size_t i = 4 * std::size_t(texel.y * plane.maps.size.x + texel.x);
      return glm::dvec3(double(values[i]), double(values[i + 1]), double(values[i + 2]));
    };
    return literatureSkin().weights[0] * at(view.light().diffuser().level(0)) +
           at(view.light().diffuser().result().map);
  }
};

// Half of the plane is lit: the table T2 of theory/skin.md, 12.2.
TEST_F(SkinViewTest, SpreadsTheEdgeOfAShadow) {
  const auto plane = skinPlane(42, kTexel);
  GpuSkin gpu;
  gpu.set(plane);
  SkinView view;
  // The edge lies between texels: a texel's middle is half a texel from it.
  view.light().spread(gpu, plainSkin(),
                      irradianceOn(*plane, [](double x, double) { return x > 0 ? 1.0 : 0.0; }));
  for (const double x : {-4.0, -2.0, -1.0, -0.5, 0.5, 1.0, 2.0, 4.0}) {
    const double middle = (std::floor(x / double(kTexel)) + 0.5) * double(kTexel);
    glm::dvec3 expected(0);
    const GaussianSum g = literatureSkin();
    for (std::size_t i = 0; i < GaussianSum::kCount; ++i)
      expected += g.weights[i] * (i == 0 ? (middle > 0 ? 1.0 : 0.0)
                                         : 0.5 * std::erfc(-middle / std::sqrt(2 * g.variances[i])));
    const glm::dvec3 found = leaving(*plane, view, x + 1e-6, 0.01);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 0.012) << x << " " << c;
  }
}

// Waves keep what the table T3 says.
TEST_F(SkinViewTest, DampsWaves) {
  struct Row {
    double period;
    glm::dvec3 amplitude;
    double tolerance;
  };
  const Row rows[] = {{2, {0.358308, 0.784579, 0.900162}, 0.032},
                      {5, {0.576710, 0.952235, 0.981304}, 0.0044},
                      {10, {0.806286, 0.987015, 0.995169}, 0.0014},
                      {20, {0.938112, 0.996669, 0.998781}, 0.0015}};
  for (const Row& row : rows) {
    // Whole periods and whole texels in the middle, which no border reaches.
    const double span = row.period > 10 ? 60 : 30;
    const auto plane = skinPlane(float(span) + 24, kTexel);
    GpuSkin gpu;
    gpu.set(plane);
    SkinView view;
    const auto wave = [&](double x, double) { return 0.5 + 0.5 * std::cos(2 * M_PI * x / row.period); };
    view.light().spread(gpu, plainSkin(), irradianceOn(*plane, wave));
    const auto level0 = gl::readFloats(view.light().diffuser().level(0), 4),
               rest = gl::readFloats(view.light().diffuser().result().map, 4);
    const int width = plane->maps.size.x, texels = int(std::lround(span / double(kTexel)));
    glm::dvec3 sum(0);
    double reference = 0;
    const int first = width / 2 - texels / 2;
    for (int i = 0; i < texels; ++i) {
      const std::size_t t = std::size_t(width / 2 * width + first + i);
      const double x = double(plane->maps.position[t].x), c = std::cos(2 * M_PI * x / row.period);
      for (int k = 0; k < 3; ++k)
        sum[k] += c * (literatureSkin().weights[0][k] * double(level0[4 * t + std::size_t(k)]) +
                       double(rest[4 * t + std::size_t(k)]));
      reference += c * wave(x, 0);
    }
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(sum[k] / reference, row.amplitude[k], row.tolerance) << row.period << " " << k;
  }
}

// A lit disc's middle: the table T4.
TEST_F(SkinViewTest, SpreadsADisc) {
  const auto plane = skinPlane(42, kTexel);
  GpuSkin gpu;
  gpu.set(plane);
  SkinView view;
  const std::pair<double, glm::dvec3> rows[] = {
      {1, {0.593700, 0.980320, 0.997091}}, {2, {0.806087, 0.998326, 0.999794}}, {5, {0.984893, 0.999993, 1}}};
  for (const auto& [radius, expected] : rows) {
    view.light().spread(gpu, plainSkin(), irradianceOn(*plane, [r = radius](double x, double y) {
                          return x * x + y * y < r * r ? 1.0 : 0.0;
                        }));
    const glm::dvec3 found = leaving(*plane, view, 0.01, 0.01);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 0.006) << radius << " " << c;
  }
}

// Light that is the same everywhere stays so, at the borders too.                      [T9]
TEST_F(SkinViewTest, WhiteFurnace) {
  const auto plane = skinPlane(20, kTexel);
  GpuSkin gpu;
  gpu.set(plane);
  SkinView view;
  LightRig rig = oneLight({0, 0, 1});
  rig.lights[0].colour = glm::vec3(0);
  rig.environment[0] = glm::vec3(1 / 0.282095f);
  view.relight(gpu, {plainSkin(), {}, rig}, {});
  const auto level0 = gl::readFloats(view.light().diffuser().level(0), 4),
             rest = gl::readFloats(view.light().diffuser().result().map, 4);
  double worst = 0;
  for (std::size_t t = 0; t < plane->maps.position.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      if (plane->maps.position[t].w > 0)
        worst = std::max(worst, std::abs(literatureSkin().weights[0][int(c)] * double(level0[4 * t + c]) +
                                         double(rest[4 * t + c]) - 1));
  EXPECT_LT(worst, 1e-3);
}

// A far light's cosine, a lamp's square law.
TEST_F(SkinViewTest, IrradianceOfFarAndNearLights) {
  const auto plane = skinPlane(20, kTexel);
  GpuSkin gpu;
  gpu.set(plane);
  SkinView view;
  view.relight(gpu, {plainSkin(), {}, oneLight({1, 0, 1})}, {});
  const auto middle = [&] {
    const auto values = gl::readFloats(view.light().diffuser().level(0), 4);
    const glm::ivec2 size = plane->maps.size;
    return double(values[4 * std::size_t(size.y / 2 * size.x + size.x / 2)]);
  };
  EXPECT_NEAR(middle(), std::sqrt(0.5), 1e-3);
  LightRig lamp;
  lamp.lights.push_back({.kind = LightKind::near,
                         .position = {0, 0, 200},
                         .colour = glm::vec3(1),
                         .reach = 100,
                         .shadows = false});
  view.relight(gpu, {plainSkin(), {}, lamp}, {});
  EXPECT_NEAR(middle(), (100.0 * 100 + 100) / (200.0 * 200 + 100), 2e-3);
}

// Turning the camera costs the final pass only: the maps keep every bit.                [T11]
TEST_F(SkinViewTest, TurningTheCameraLeavesTheLight) {
  const auto plane = skinPlane(20, kTexel);
  GpuSkin gpu;
  gpu.set(plane);
  SkinView view;
  const SkinLook look{plainSkin(), {}, oneLight({1, 0, 1})};
  Camera camera = lookAlong({0, 0, -1}, {0, 1, 0}, gpu.box(), 1);
  const gl::Framebuffer picture({.size = {64, 64}});
  view.draw({.surface = gpu, .camera = camera, .look = look, .quality = {}}, picture);
  EXPECT_TRUE((view.state() >= LightState::complete));
  const auto level = gl::readFloats(view.light().diffuser().level(5), 4),
             diffused = gl::readFloats(view.light().diffuser().result().map, 4);
  const auto first = gl::readImage(picture);
  camera.orbit(0.5f, 0.2f);
  view.draw({.surface = gpu, .camera = camera, .look = look, .quality = {}, .steps = 0}, picture);
  EXPECT_TRUE((view.state() >= LightState::complete));
  EXPECT_EQ(level, gl::readFloats(view.light().diffuser().level(5), 4));
  EXPECT_EQ(diffused, gl::readFloats(view.light().diffuser().result().map, 4));
  EXPECT_NE(first.rgba, gl::readImage(picture).rgba);
}

// Light that is dragged about is finished in between, one pass a frame: what is shown is the whole light of some frame
// before, and the next one is worked on from the frame that follows.
TEST_F(SkinViewTest, StepsArriveWhileLightMoves) {
  const auto plane = skinPlane(10, kTexel);
  GpuSkin gpu;
  gpu.set(plane);
  SkinView view, whole;
  const Camera camera = lookAlong({0, 0, -1}, {0, 1, 0}, gpu.box(), 1);
  const gl::Framebuffer picture({.size = {32, 32}});
  const auto look = [](int frame) {
    return SkinLook{plainSkin(), {}, oneLight({0.02f * float(frame), 0, 1})};
  };
  std::vector<float> shown;
  int begun = 0, arrived = 0;
  for (int frame = 0; frame < 40; ++frame) {
    view.draw({.surface = gpu, .camera = camera, .look = look(frame), .quality = {}, .steps = 1}, picture);
    EXPECT_LT(view.state(), LightState::complete) << "the light has moved on";
    std::vector<float> now = gl::readFloats(view.light().diffuser().result().map, 4);
    if (frame > 0 && now != shown) {
      whole.relight(gpu, look(begun), {});
      EXPECT_EQ(now, gl::readFloats(whole.light().diffuser().result().map, 4)) << frame;
      begun = frame + 1;
      ++arrived;
    }
    shown = std::move(now);
  }
  EXPECT_GE(arrived, 3);
  for (int frame = 0; frame < 30 && view.state() < LightState::complete; ++frame)  // it rests
    view.draw({.surface = gpu, .camera = camera, .look = look(40), .quality = {}, .steps = 1}, picture);
  ASSERT_GE(view.state(), LightState::complete);
  whole.relight(gpu, look(40), {});
  EXPECT_EQ(gl::readFloats(view.light().diffuser().result().map, 4),
            gl::readFloats(whole.light().diffuser().result().map, 4));
}

}  // namespace
}  // namespace sonoskin
