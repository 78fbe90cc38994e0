#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

#include "app/application.h"
#include "app/commands.h"
#include "app/widgets/widget_rects.h"
#include "core/base/timer.h"
#include "core/io/image.h"
#include "render/gl/context.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;

// Driver: runs the program's own window and moves the real mouse of the display in it.
class Driver {
 public:
  explicit Driver(const Parameters& parameters) : application(std::nullopt, parameters) {
    ImGui::GetIO().UserData = &rects_;
    ImGui::GetIO().MouseDoubleClickTime = 5;  // frames may be slow where many tests run
  }

  Workspace& workspace() { return application.workspace(); }
  Session& session() { return workspace().session; }
  bool alive() const { return alive_; }

  void frames(int count) {
    for (int i = 0; i < count && alive_; ++i) {
      application.requestFrame();
      alive_ = application.frame();
    }
  }
  // wait: frames until the condition holds; false after `seconds`.
  bool wait(const std::function<bool()>& condition, double seconds = 60) {
    const Timer timer;
    while (!condition()) {
      if (timer.seconds() > seconds) return false;
      frames(1);
    }
    return true;
  }
  bool waitUntilIdle() {
    return wait([this] { return session().hasScan() && !session().activity().busy; });
  }

  bool knows(const std::string& widget) const { return rects_.byName.contains(widget); }
  // point: a place inside a widget, as shares of its sides.
  ImVec2 point(const std::string& widget, float x = 0.5f, float y = 0.5f) const {
    const auto found = rects_.byName.find(widget);
    if (found == rects_.byName.end()) {
      ADD_FAILURE() << "no widget " << widget;
      return {};
    }
    const auto& [min, max] = found->second;
    return {min.x + x * (max.x - min.x), min.y + y * (max.y - min.y)};
  }
  void mouse(const std::string& action) {
    ASSERT_EQ(std::system(("xdotool " + action).c_str()), 0) << action;
    frames(3);
  }
  void moveTo(ImVec2 p) { mouse("mousemove " + std::to_string(int(p.x)) + " " + std::to_string(int(p.y))); }
  void click(const std::string& widget) {
    moveTo(point(widget));
    mouse("mousedown 1");
    mouse("mouseup 1");
  }
  void drag(ImVec2 from, ImVec2 to, int button = 1) {
    moveTo(from);
    mouse("mousedown " + std::to_string(button));
    moveTo({0.5f * (from.x + to.x), 0.5f * (from.y + to.y)});
    moveTo(to);
    mouse("mouseup " + std::to_string(button));
  }
  void doubleClick(const std::string& widget) {
    moveTo(point(widget));
    for (const char* action : {"mousedown 1", "mouseup 1", "mousedown 1", "mouseup 1"}) mouse(action);
  }
  void press(const std::string& keys) {
    mouse("keydown " + keys);
    mouse("keyup " + keys);
  }

  // screenshot: the display's pixels as they are.
  Image screenshot(const std::string& name) {
    frames(3);
    const fs::path path = fs::temp_directory_path() / (name + ".png");
    EXPECT_EQ(std::system(("import -silent -window root -depth 8 png32:" + path.string()).c_str()), 0);
    return readPng(path);
  }

  Application application;

 private:
  ui::WidgetRects rects_;
  bool alive_ = true;
};

Parameters smallPhantom() {
  Parameters parameters;
  parameters.phantom.dims = {156, 85, 62};
  parameters.mesh.resolution = 120;
  return parameters;
}

struct Colour {
  int r, g, b;
};
Colour pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
  return {p[0], p[1], p[2]};
}

// The share of the pixels of a pane, away from its marks, for which `test` holds.
double share(const Image& image, const Driver& driver, const char* pane,
             const std::function<bool(Colour)>& test) {
  const ImVec2 from = driver.point(pane, 0.05f, 0.12f), to = driver.point(pane, 0.95f, 0.85f);
  int count = 0, all = 0;
  for (int y = int(from.y); y < int(to.y); ++y) {
    for (int x = int(from.x); x < int(to.x); ++x, ++all) count += test(pixel(image, x, y));
  }
  return all == 0 ? 0 : double(count) / all;
}

bool isSurface(Colour c) { return c.r > 70 && c.r > c.b + 8; }  // clay is warm, the background is dark blue

double difference(const Image& a, const Image& b, const Driver& driver, const char* pane) {
  const ImVec2 from = driver.point(pane, 0.05f, 0.12f), to = driver.point(pane, 0.95f, 0.85f);
  int count = 0, all = 0;
  for (int y = int(from.y); y < int(to.y); ++y) {
    for (int x = int(from.x); x < int(to.x); ++x, ++all) {
      count += std::abs(pixel(a, x, y).g - pixel(b, x, y).g) > 12;
    }
  }
  return all == 0 ? 0 : double(count) / all;
}

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    // The person's own settings are neither read nor written.
    setenv("XDG_CONFIG_HOME", (fs::temp_directory_path() / "sonoskin_window_test").c_str(), 1);
    driver = std::make_unique<Driver>(smallPhantom());
  }
  std::unique_ptr<Driver> driver;
};

// The main way through the program, with the mouse: open, move a slider, see the new result, reconstruct, see the mesh.
TEST_F(WindowTest, SliderAndReconstruction) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  ASSERT_TRUE(d.session().results().classified);
  d.click("view.layer.Classified");
  EXPECT_EQ(d.workspace().view.layer, SliceLayer::classified);
  const Image before = d.screenshot("sonoskin_before");
  EXPECT_GT(share(before, d, "pane.axial", [](Colour c) { return c.g > 40; }), 0.01) << "the slice is blank";

  const auto old = d.session().results().classified;
  const double oldBeta = d.session().parameters().classification.beta;
  d.drag(d.point("classification.beta", float(oldBeta / 4)), d.point("classification.beta", 0.9f));
  EXPECT_GT(d.session().parameters().classification.beta, 3);
  EXPECT_TRUE(d.session().canUndo());
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_NE(d.session().results().classified, old);
  EXPECT_EQ(d.session().results().classified->geometry.dims, d.session().scan().volume->geometry.dims);
  const Image after = d.screenshot("sonoskin_after");
  EXPECT_GT(difference(before, after, d, "pane.axial"), 0.002) << "the slice did not follow the slider";

  d.press("ctrl+z");
  EXPECT_DOUBLE_EQ(d.session().parameters().classification.beta, oldBeta);
  ASSERT_TRUE(d.waitUntilIdle());

  d.click("surface.reconstruct");
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  ASSERT_TRUE(d.waitUntilIdle());
  ASSERT_TRUE(d.session().results().mesh);
  EXPECT_TRUE(d.session().meshIsCurrent());
  EXPECT_EQ(d.workspace().view.content, SpaceContent::mesh);
  d.moveTo({5, 5});
  const Image mesh = d.screenshot("sonoskin_mesh");
  const double lit = share(mesh, d, "pane.space", isSurface);
  EXPECT_GT(lit, 0.08) << "no lit surface in the 3D view";
  EXPECT_LT(lit, 0.95);

  d.drag(d.point("pane.space", 0.4f), d.point("pane.space", 0.6f));
  EXPECT_GT(difference(mesh, d.screenshot("sonoskin_turned"), d, "pane.space"), 0.02)
      << "the mouse does not rotate";
  EXPECT_TRUE(d.workspace().toasts.list.empty()) << d.workspace().toasts.list.front().text;
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
  EXPECT_TRUE(d.alive());
}

TEST_F(WindowTest, MouseInSlices) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const Geometry& g = d.session().scan().volume->geometry;
  const auto index = [&] { return g.toIndex(d.workspace().view.cursor); };
  const glm::dvec3 middle = index();

  d.drag(d.point("pane.axial", 0.5f, 0.5f), d.point("pane.axial", 0.6f, 0.4f));
  EXPECT_GT(index().x, middle.x + 5);
  EXPECT_LT(index().y, middle.y - 3);
  EXPECT_NEAR(index().z, middle.z, 1e-6);

  d.mouse("click 4");  // the wheel, away from the person
  EXPECT_NEAR(std::abs(index().z - middle.z), 1, 1e-6);
  const double zoom = d.workspace().view.slices[std::size_t(Plane::axial)].zoom;
  d.mouse("keydown ctrl");
  d.mouse("click 4");
  d.mouse("keyup ctrl");
  EXPECT_GT(d.workspace().view.slices[std::size_t(Plane::axial)].zoom, zoom);

  const float width = d.workspace().view.grey.width;
  d.drag(d.point("pane.axial", 0.3f), d.point("pane.axial", 0.2f), 3);
  EXPECT_LT(d.workspace().view.grey.width, width);
  d.drag(d.point("pane.axial", 0.3f), d.point("pane.axial", 0.2f), 2);
  EXPECT_LT(d.workspace().view.slices[std::size_t(Plane::axial)].pan.x, 0);

  d.doubleClick("pane.coronal");
  EXPECT_EQ(d.workspace().view.maximised, Pane::coronal);
  d.press("Escape");
  EXPECT_FALSE(d.workspace().view.maximised);
}

TEST_F(WindowTest, CancelAndErrors) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.session().reconstruct();
  const Timer timer;
  d.session().cancel();
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_LT(timer.seconds(), 2);
  EXPECT_EQ(d.session().reconstructions(), 0u);

  // A file that cannot be read is told in one sentence; what was open stays.
  const Key scan = d.session().scan().key;
  d.workspace().open("/nowhere/face.nrrd");
  ASSERT_TRUE(d.wait([&] { return !d.workspace().toasts.list.empty(); }));
  EXPECT_TRUE(d.workspace().toasts.list.front().failure);
  EXPECT_EQ(d.session().scan().key, scan);
}

TEST_F(WindowTest, SavesMeshFromTheDialog) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.session().reconstruct();
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  const fs::path folder = fs::temp_directory_path() / "sonoskin_window_test_out";
  fs::remove_all(folder);
  fs::create_directories(folder);
  d.workspace().settings.folder = folder;
  d.press("ctrl+s");
  ASSERT_TRUE(d.workspace().files.purpose);
  d.frames(3);
  d.press("Return");
  ASSERT_TRUE(d.wait([&] { return fs::exists(folder / "Phantom.recipe.json"); }, 20));
  EXPECT_GT(fs::file_size(folder / "Phantom.ply"), 10000u);
  EXPECT_FALSE(d.workspace().files.purpose);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace sonoskin
