// The parts of the surface with the real mouse: clicks, a line, undo, Escape.
#include "app/document/part_edits.h"
#include "app/views/projection.h"
#include "render/gl/context.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class PartsWindowTest : public WindowTest {
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
    d.workspace().view.camera.distance *= 1.6f;  // shoulders, too
    d.frames(3);
    clay_ = d.screenshot("sonoskin_parts_clay");
    d.press("p");
    ASSERT_TRUE(d.workspace().view.parts);
    d.frames(5);
  }

  const Results& results() { return driver->session().results(); }
  std::ptrdiff_t kept() {
    return std::count_if(results().verdicts->begin(), results().verdicts->end(),
                         [](const PartVerdict& v) { return v.kept; });
  }
  std::uint32_t face() {
    std::uint32_t p = 0;
    while ((*results().verdicts)[p].reason != PartReason::face) ++p;
    return p;
  }
  // The largest part that is kept beside the face's.
  std::uint32_t beside() {
    std::uint32_t p = 0;
    while (!(*results().verdicts)[p].kept || p == face()) ++p;
    return p;
  }
  ui::PaneInput pane() {
    const ImVec2 low = driver->point("pane.space", 0, 0), high = driver->point("pane.space", 1, 1);
    ui::PaneInput pane;
    pane.corner = {low.x, low.y};
    pane.size = {high.x - low.x, high.y - low.y};
    return pane;
  }
  // A place on the screen where a part is seen, before all others.
  ImVec2 seen(std::uint32_t part) {
    const Camera& camera = driver->workspace().view.camera;
    const PartedSurface& surface = *results().parts;
    for (std::size_t t = 0; t < surface.mesh.triangles.size(); t += 7) {
      if (surface.parts.ofTriangle[t] != part) continue;
      const auto at = ui::seenAt(surface.mesh.positions[surface.mesh.triangles[t][0]], camera, pane());
      if (!at || at->x < pane().corner.x + 20 || at->y < pane().corner.y + 30) continue;
      if (at->x > pane().corner.x + pane().size.x - 20 || at->y > pane().corner.y + pane().size.y - 40)
        continue;
      const glm::vec2 mouse = glm::floor(*at) - pane().corner;
      // Not at the very edge of the part.
      bool whole = true;
      for (const glm::vec2& by :
           {glm::vec2(0, 0), glm::vec2(5, 0), glm::vec2(-5, 0), glm::vec2(0, 5), glm::vec2(0, -5)}) {
        const auto pick = pickPart(results(), camera.eye(), ui::rayThrough(mouse + by, camera, pane()));
        whole &= pick && pick->part == part;
      }
      if (whole) return {std::floor(at->x), std::floor(at->y)};
    }
    ADD_FAILURE() << "part " << part << " is not seen";
    return {};
  }
  void clickAt(ImVec2 p) {
    driver->moveTo(p);
    driver->mouse("mousedown 1");
    driver->mouse("mouseup 1");
    ASSERT_TRUE(driver->waitUntilIdle());
    driver->frames(3);
  }

  Image clay_;
};

TEST_F(PartsWindowTest, ClicksTakePartsAwayAndBringThemBack) {
  Driver& d = *driver;
  const Image colours = d.screenshot("sonoskin_parts");
  EXPECT_GT(difference(clay_, colours, d, "pane.space"), 0.02);
  EXPECT_GT(share(colours, d, "pane.space",
                  [](Colour c) {
                    return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) > 60;
                  }),
            0.02)
      << "colours, not clay";
  const std::ptrdiff_t before = kept();
  ASSERT_GE(before, 2) << "a hand or shoulders beside the face";
  const std::size_t triangles = results().mesh->triangles.size();
  const std::uint32_t clicked = beside();
  const ImVec2 at = seen(clicked);
  clickAt(at);
  EXPECT_FALSE((*results().verdicts)[clicked].kept);
  EXPECT_LT(kept(), before);  // with it goes what it alone joined to the face
  EXPECT_LT(results().mesh->triangles.size(), triangles);
  EXPECT_EQ(d.session().parameters().mesh.partsDrop.size(), 1u);
  d.moveTo({5, 5});
  EXPECT_GT(difference(colours, d.screenshot("sonoskin_parts_dimmed"), d, "pane.space"), 0.01);
  clickAt(at);
  EXPECT_EQ(kept(), before);
  EXPECT_EQ(results().mesh->triangles.size(), triangles);
  EXPECT_TRUE(d.session().parameters().mesh.partsDrop.empty());

  clickAt(at);
  d.press("ctrl+z");
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_EQ(kept(), before);

  // Two clicks at most to the face alone: here one, with Shift.
  d.mouse("keydown shift");
  clickAt(seen(face()));
  d.mouse("keyup shift");
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_EQ(kept(), 1);
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

TEST_F(PartsWindowTest, ALineSplitsAndEscapeLeaves) {
  Driver& d = *driver;
  const std::size_t parts = results().parts->parts.parts.size();
  const auto camera = d.workspace().view.camera;
  const ImVec2 at = seen(face());
  // A drag without Ctrl turns the camera and takes nothing away.
  d.drag(at, {at.x + 40, at.y});
  EXPECT_NE(d.workspace().view.camera.forward, camera.forward);
  EXPECT_TRUE(d.session().parameters().mesh.partsDrop.empty());
  d.workspace().view.camera = camera;
  d.frames(3);
  d.mouse("keydown ctrl");
  d.drag({at.x - 60, at.y}, {at.x + 60, at.y});
  d.mouse("keyup ctrl");
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_EQ(d.session().parameters().mesh.partsCut.size(), 3u);
  EXPECT_EQ(results().parts->parts.parts.size(), parts + 1);
  d.moveTo({5, 5});
  d.frames(3);
  d.screenshot("sonoskin_parts_split");
  d.press("ctrl+z");
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_EQ(results().parts->parts.parts.size(), parts);
  d.press("Escape");
  EXPECT_FALSE(d.workspace().view.parts);
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

}  // namespace
}  // namespace sonoskin
