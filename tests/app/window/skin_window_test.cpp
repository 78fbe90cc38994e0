// The skin view with the real mouse: the look, the lamp, the halves, landmarks.
#include "app/document/landmarks.h"
#include "render/gl/context.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class SkinWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    Driver& d = *driver;
    ASSERT_TRUE(d.waitUntilIdle());
    d.session().reconstruct();
    ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
    ASSERT_TRUE(d.waitUntilIdle());
    d.moveTo({5, 5});
    d.press("m");
    ASSERT_EQ(d.workspace().view.meshStyle, MeshStyle::clay);
    d.frames(3);
    plain_ = d.screenshot("sonoskin_skin_plain");
    d.press("s");
    ASSERT_EQ(d.workspace().view.meshStyle, MeshStyle::skin);
    // Prepared, lit, and drawn in full: the time of a picture is known then.
    ASSERT_TRUE(d.wait([&] { return d.workspace().view.skin.status.milliseconds > 0; }));
    settle();
  }
  // settle: until the picture is the final one.
  void settle() {
    driver->frames(3);
    ASSERT_TRUE(driver->wait([&] { return driver->workspace().view.skin.status.settled; }));
    driver->frames(3);
  }
  ImVec2 lamp() const { return driver->point("lamp"); }

  Image plain_;
};

TEST_F(SkinWindowTest, ShowsSkinAndMovesTheLamp) {
  Driver& d = *driver;
  EXPECT_GT(d.workspace().view.skin.status.milliseconds, 0);
  const Image skin = d.screenshot("sonoskin_skin");
  EXPECT_GT(difference(plain_, skin, d, "pane.space"), 0.1) << "skin does not look like clay";
  EXPECT_GT(share(skin, d, "pane.space", [](Colour c) { return c.r > 90 && c.r > c.b + 25; }), 0.08);

  const LightOptions before = d.session().parameters().light;
  const ImVec2 from = lamp(), middle = d.point("pane.space");
  d.drag(from, {middle.x + 0.8f * (middle.x - from.x), from.y});
  const LightOptions moved = d.session().parameters().light;
  EXPECT_GT(moved.azimuth, before.azimuth + 30);
  EXPECT_NEAR(lamp().x, middle.x + 0.8f * (middle.x - from.x), 3) << "the mark follows the mouse";
  d.moveTo({5, 5});
  settle();
  EXPECT_GT(difference(skin, d.screenshot("sonoskin_skin_lamp"), d, "pane.space"), 0.05);
  EXPECT_TRUE(d.session().meshIsCurrent());
  EXPECT_FALSE(d.session().activity().busy);

  d.press("ctrl+z");
  EXPECT_EQ(d.session().parameters().light, before);
  EXPECT_TRUE(d.workspace().toasts.list.empty()) << d.workspace().toasts.list.front().text;
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

TEST_F(SkinWindowTest, DragsTheLampBehindAndTurnsItsDistance) {
  Driver& d = *driver;
  Parameters p = d.session().parameters();
  p.light.kind = LightKind::near;
  d.session().edit(p);
  d.session().commitEdit();
  d.frames(3);
  const ImVec2 middle = d.point("pane.space"), corner = d.point("pane.space", 0, 0);
  const float height = 2 * (middle.y - corner.y), width = 2 * (middle.x - corner.x);
  d.drag(lamp(), {middle.x + 0.44f * std::min(width, height), middle.y});
  EXPECT_GT(d.session().parameters().light.azimuth, 100) << "beyond the rim is behind";
  const double distance = d.session().parameters().light.distance,
               zoom = double(d.workspace().view.camera.distance);
  d.mouse("click 4");
  d.mouse("click 4");
  EXPECT_LT(d.session().parameters().light.distance, 0.9 * distance);
  EXPECT_EQ(double(d.workspace().view.camera.distance), zoom) << "the wheel is the lamp's there";
  d.moveTo({5, 5});
  settle();
  d.screenshot("sonoskin_skin_behind");
  d.press("ctrl+z");
  EXPECT_EQ(d.session().parameters().light.distance, distance) << "both turns are one step";
}

TEST_F(SkinWindowTest, ShowsTheSkinThatIsThereWhileABetterOneIsPrepared) {
  Driver& d = *driver;
  const Image before = d.screenshot("sonoskin_skin_before");
  d.workspace().settings.skinQuality = SkinQualityChoice::full;
  d.frames(2);
  d.workspace().view.camera.orbit(0.001f, 0);  // hardly, but the picture is drawn anew
  d.frames(2);
  EXPECT_FALSE(d.workspace().view.skin.status.full);
  EXPECT_LT(difference(before, d.screenshot("sonoskin_skin_between"), d, "pane.space"), 0.05);
  ASSERT_TRUE(d.wait([&] { return d.workspace().view.skin.status.full; }));
}

// Whoever still held a volume or a surface of it would hold its memory.
TEST_F(SkinWindowTest, GivesTheMemoryOfAClosedDocumentBack) {
  Driver& d = *driver;
  const Results& results = d.session().results();
  const std::weak_ptr<const Mesh> mesh = results.mesh;
  const std::weak_ptr<const Volume<float>> volume = d.session().scan().volume,
                                           classified = results.classified;
  const std::weak_ptr<const Volume<std::uint8_t>> thinned = results.thinned;
  Parameters p = d.session().parameters();
  p.phantom.seed += 1;
  d.session().edit(p);
  d.session().commitEdit();
  d.session().openPhantom();
  ASSERT_TRUE(d.wait([&] { return d.session().scan().volume != volume.lock(); }));
  ASSERT_TRUE(d.waitUntilIdle());
  d.frames(3);
  EXPECT_TRUE(mesh.expired());
  EXPECT_TRUE(volume.expired());
  EXPECT_TRUE(classified.expired());
  EXPECT_TRUE(thinned.expired());
}

// A busy machine may smooth edges in one of two pictures only: of the two pixels one lies between those around the other then.
constexpr int kOutline = 1;

// Whether pixel (x, y) of b differs from all that lie between the pixels of a up to `reach` away.
bool differs(const Image& a, const Image& b, int x, int y, int reach) {
  const Colour q = pixel(b, x, y);
  Colour low = pixel(a, x, y), high = low;
  for (int j = y - reach; j <= y + reach; ++j)
    for (int i = x - reach; i <= x + reach; ++i) {
      const Colour p = pixel(a, i, j);
      low = {std::min(low.r, p.r), std::min(low.g, p.g), std::min(low.b, p.b)};
      high = {std::max(high.r, p.r), std::max(high.g, p.g), std::max(high.b, p.b)};
    }
  const auto outside = [](int value, int least, int most) {
    return std::max({least - value, value - most, 0});
  };
  return outside(q.r, low.r, high.r) + outside(q.g, low.g, high.g) + outside(q.b, low.b, high.b) > 12;
}

// The share of the pixels left and right of the line, between `from` and `to` of the pane's width, that differ.
double changed(const Image& a, const Image& b, const Driver& d, float from, float to, int reach = 0) {
  const ImVec2 first = d.point("pane.space", from, 0.15f), last = d.point("pane.space", to, 0.85f);
  int count = 0, all = 0;
  for (int y = int(first.y); y < int(last.y); ++y)
    for (int x = int(first.x); x < int(last.x); ++x, ++all)
      count += differs(a, b, x, y, reach) && differs(b, a, x, y, reach);
  return all == 0 ? 0 : double(count) / all;
}

TEST_F(SkinWindowTest, ComparesHalves) {
  Driver& d = *driver;
  d.workspace().view.skin.lamp = false;
  settle();
  const Image whole = d.screenshot("sonoskin_skin_whole");
  d.workspace().view.skin.compare = SkinCompare::scatter;
  settle();
  const ImVec2 middle = d.point("pane.space");
  d.drag({middle.x, middle.y + 150}, {middle.x + 60, middle.y + 150});
  const float divider = d.workspace().view.skin.divider;
  EXPECT_GT(divider, 0.53f);
  d.moveTo({5, 5});
  settle();
  const Image scatter = d.screenshot("sonoskin_skin_scatter");
  EXPECT_GT(changed(whole, scatter, d, 0.1f, divider - 0.02f), 0.01) << "without light below the surface";
  EXPECT_EQ(changed(whole, scatter, d, divider + 0.02f, 0.9f, kOutline), 0) << "as it was";

  // A is kept, B is clay.
  d.workspace().view.skin.compare = SkinCompare::settings;
  d.workspace().view.skin.kept = {d.session().parameters().skin, d.session().parameters().light,
                                  d.session().parameters().landmarks};
  Parameters p = d.session().parameters();
  p.skin.colour = SkinColour::clay;
  d.session().edit(p);
  settle();
  const Image settings = d.screenshot("sonoskin_skin_ab");
  EXPECT_LT(changed(whole, settings, d, 0.1f, divider - 0.02f, kOutline), 0.002);
  EXPECT_GT(changed(whole, settings, d, divider + 0.02f, 0.9f), 0.05);
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

// Its open headings mark what they are about, and with another step the marks go.
TEST_F(SkinWindowTest, OpensItsPanel) {
  Driver& d = *driver;
  d.openStep(Step::skin);
  const ImVec2 lookAt = d.point("look");
  EXPECT_GT(lookAt.y, 0);
  EXPECT_LT(lookAt.y, 500) << "below the edge of the window";
  d.click("foldout.Scattering");
  EXPECT_TRUE(d.workspace().view.skin.reach);
  d.moveTo({5, 5});
  d.workspace().view.maximised = Pane::space;
  settle();
  d.screenshot("sonoskin_skin_panel");
  d.openStep(Step::surface);
  EXPECT_FALSE(d.workspace().view.skin.reach);
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

TEST_F(SkinWindowTest, PlacesALandmarkWithAClick) {
  Driver& d = *driver;
  d.workspace().view.spaceTool = Tool::landmark;
  d.workspace().view.landmark = 2;
  const ImVec2 nose = d.point("pane.space");
  d.moveTo(nose);
  d.mouse("mousedown 1");
  d.mouse("mouseup 1");
  EXPECT_EQ(d.workspace().view.spaceTool, Tool::crossHair);
  const auto& place = d.session().parameters().landmarks.noseTip;
  ASSERT_TRUE(isSet(place));
  const glm::vec3 at(place[0], place[1], place[2]);
  float nearest = 1e9f;
  for (const glm::vec3& v : d.session().results().mesh->positions)
    nearest = std::min(nearest, glm::distance(v, at));
  EXPECT_LT(nearest, 1.5f) << "on the surface";
  const Camera& camera = d.workspace().view.camera;
  EXPECT_GT(glm::dot(glm::normalize(at - camera.eye()), camera.forward), 0.9999f) << "below the mouse";
  EXPECT_TRUE(d.session().canUndo());
}

}  // namespace
}  // namespace sonoskin
