// Every value of every choice of skin and light, in pairs, and every number at both ends of its range: a picture comes of
// it, and no light is not a number.
#include <gtest/gtest.h>

#include "core/pipeline/parameters.h"
#include "render/gl/read_pixels.h"
#include "render/skin/light_passes.h"
#include "render/skin/skin_view.h"
#include "tests/render/support/gl_test.h"
#include "tests/support/legal_values.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

class LegalLooksTest : public GlTest {
 protected:
  LegalLooksTest() {
    context().makeCurrent();
    quality_.texel = 1;
    quality_.shadowSize = 64;
    quality_.shadowTaps = 9;
    mesh_ = std::make_shared<const Mesh>(test::icosphere(3, 30, {1, 2, 3}));
    gpu_.set(prepareSkin(mesh_, {0, -1, 0}, quality_));
    camera_ = lookAlong({0, 1, 0}, {0, 0, 1}, gpu_.box(), 1);
  }

  // What is not finite or negative in what was computed.
  int faultsOf(const gl::Texture& map) const {
    int faults = 0;
    for (const glm::vec4& texel : gl::readTexels(map))
      for (int c = 0; c < 4; ++c) faults += !(texel[c] >= 0 && texel[c] < 1e6f);
    return faults;
  }
  void expectLight(const Parameters& p, SkinPass pass, bool points, const std::string& what) {
    const SkinLook look{p.skin, p.landmarks, makeLightRig(p.light, homeFrame(camera_), gpu_.box())};
    quality_.diffusion = points ? DiffusionMethod::points : DiffusionMethod::blurs;
    const gl::Framebuffer picture({.size = {40, 30}});
    ASSERT_NO_THROW(view_.draw(
        {.surface = gpu_, .camera = camera_, .look = look, .quality = quality_, .pass = pass}, picture))
        << what;
    EXPECT_TRUE((view_.state() >= LightState::complete)) << what;
    EXPECT_EQ(faultsOf(view_.light().diffuser().level(0)) + faultsOf(view_.light().diffuser().result().map) +
                  faultsOf(view_.light().entering().albedo()) + faultsOf(view_.light().entering().finish()),
              0)
        << what;
    EXPECT_EQ(gl::glErrorCount(), errors_) << what << gl::lastGlError();
  }

  static bool isLook(const std::string& group) { return group == "skin" || group == "light"; }

  SkinQuality quality_;
  std::shared_ptr<const Mesh> mesh_;
  GpuSkin gpu_;
  SkinView view_;
  Camera camera_;
  int errors_ = gl::glErrorCount();
};

TEST_F(LegalLooksTest, InPairs) {
  Parameters p;
  SkinPass pass = SkinPass::skin;
  bool points = false;
  std::vector<test::Choice> choices = test::choicesOf(p, isLook);
  choices.push_back({"pass", int(enumNames(SkinPass{}).size()), [&](int value) { pass = SkinPass(value); }});
  choices.push_back({"points", 2, [&](int value) { points = value == 1; }});
  test::chooseInPairs(choices, [&](const std::string& chosen) { expectLight(p, pass, points, chosen); });
}

TEST_F(LegalLooksTest, AtTheEndsOfAllRanges) {
  for (const LightKind kind : {LightKind::far, LightKind::near, LightKind::inside}) {
    Parameters usual;
    usual.light.kind = kind;
    usual.skin.profile = ScatterProfile::custom;
    test::forEachEnd(usual, [&](const std::string& name, const Parameters& p) {
      const std::string group = name.substr(0, name.find('.'));
      if (group == "light" || (group == "skin" && kind == LightKind::near))
        expectLight(p, SkinPass::skin, false, name + " " + enumNames(kind)[std::size_t(kind)]);
    });
  }
}

// Two plates that face each other: a lamp between them that is told no distance has no direction to look in.
TEST_F(LegalLooksTest, ALampInTheVeryMiddleLightsWhatItSees) {
  Mesh plates;
  for (const float y : {30.f, -30.f}) {
    const auto base = std::uint32_t(plates.positions.size());
    for (const glm::vec2 corner : {glm::vec2(-20, -20), {20, -20}, {20, 20}, {-20, 20}}) {
      plates.positions.emplace_back(corner.x, y, corner.y);
      plates.normals.emplace_back(0, y > 0 ? -1 : 1, 0);
    }
    for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}})
      plates.triangles.push_back({base + t[0], base + t[y > 0 ? 1 : 2], base + t[y > 0 ? 2 : 1]});
  }
  const auto surface = prepareSkin(std::make_shared<const Mesh>(plates), {0, -1, 0}, quality_);
  gpu_.set(surface);
  LightOptions light;
  light.kind = LightKind::near;
  light.distance = light.fill = light.rim = light.surround = 0;
  const Box box = gpu_.box();
  view_.relight(gpu_, {{}, {}, makeLightRig(light, homeFrame(camera_), box)}, quality_);
  const std::vector<glm::vec4> lit = gl::readTexels(view_.light().diffuser().level(0));
  int bright = 0, shown = 0;
  for (std::size_t t = 0; t < lit.size(); ++t) {
    if (surface->maps.position[t].w < 1 || surface->maps.position[t].y < 0) continue;
    ++shown;
    bright += lit[t].g > 0.02f;
  }
  EXPECT_GT(shown, 1000);
  EXPECT_GT(bright, shown / 2);
}

}  // namespace
}  // namespace sonoskin
