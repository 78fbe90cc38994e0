#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "core/io/volume_writer.h"
#include "render/gl/context.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

bool isSurface(Colour c) { return c.r > 70 && c.r > c.b + 8; }  // clay is warm, the background is dark blue

// The main way through the program, with the mouse: open, move a slider, see the new result, reconstruct, see the mesh.
TEST_F(WindowTest, SliderAndReconstruction) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  ASSERT_TRUE(d.session().results().classified);
  d.click("view.layer.Classified");
  EXPECT_EQ(d.workspace().view.layer, SliceLayer::classified);
  const Image before = d.screenshot("sonoskin_before");
  EXPECT_GT(share(before, d, "pane.axial", [](Colour c) { return c.g > 40; }), 0.01) << "the slice is blank";

  d.openStep(Step::classify);
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
  EXPECT_EQ(d.workspace().view.meshStyle, MeshStyle::skin);
  d.moveTo({5, 5});
  EXPECT_GT(share(d.screenshot("sonoskin_first_skin"), d, "pane.space", isSurface), 0.08)
      << "nothing while skin is prepared";
  d.press("m");
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

  const glm::dvec3 cursor = d.workspace().view.cursor;
  d.moveTo(d.point("pane.coronal", 0.3f, 0.3f));
  for (const char* action : {"mousedown 1", "mouseup 1", "mousedown 1", "mouseup 1"}) d.mouse(action);
  EXPECT_EQ(d.workspace().view.maximised, Pane::coronal);
  EXPECT_EQ(d.workspace().view.cursor, cursor) << "a double click leaves the cross-hair alone";
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

// Nothing unsaved goes without a question, which is asked once.
TEST_F(WindowTest, AsksBeforeUnsavedWorkIsLost) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.session().reconstruct();
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  const Key scan = d.session().scan().key;
  d.press("ctrl+q");
  d.frames(3);
  EXPECT_TRUE(d.workspace().question);
  EXPECT_FALSE(d.workspace().quit);
  d.screenshot("sonoskin_question");
  d.press("Escape");
  d.frames(3);
  EXPECT_FALSE(d.workspace().question || d.workspace().quit);
  d.workspace().open("/nowhere/face.nrrd");
  d.frames(3);
  EXPECT_TRUE(d.workspace().question);
  d.click("question.back");
  d.frames(3);
  EXPECT_FALSE(d.workspace().question);
  EXPECT_EQ(d.session().scan().key, scan);
  d.press("ctrl+q");
  d.frames(3);
  d.click("question.discard");
  d.frames(1);
  EXPECT_TRUE(d.workspace().quit);
}

TEST_F(WindowTest, SavesMeshFromTheDialog) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.session().reconstruct();
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  d.workspace().settings.folder = folder.path();
  d.press("ctrl+s");
  ASSERT_TRUE(d.workspace().files.purpose);
  d.frames(3);
  d.press("Return");
  ASSERT_TRUE(d.wait([&] { return fs::exists(folder / "surface.recipe.json"); }, 20));
  EXPECT_GT(fs::file_size(folder / "surface.ply"), 10000u);
  EXPECT_FALSE(d.workspace().files.purpose);
}

// The size of a larger screen was remembered, or one that is too large at another scale.
TEST_F(WindowTest, IsNotLargerThanTheScreen) {
  struct Remembered {
    int width, height;
    double scale;
  };
  for (const Remembered& remembered : {Remembered{4000, 4000, 0}, Remembered{1500, 940, 2}}) {
    driver.reset();  // writes the settings
    Settings settings = readSettings(settingsFile());
    settings.width = remembered.width;
    settings.height = remembered.height;
    settings.scale = remembered.scale;
    writeSettings(settingsFile(), settings);
    driver = std::make_unique<Driver>(smallPhantom());
    driver->frames(3);
    const ImVec2 size = ImGui::GetMainViewport()->Size;
    EXPECT_LE(size.x, 1600);
    EXPECT_LE(size.y, 1000);
    EXPECT_GE(size.y, 900);
  }
}

int messagesWith(const Driver& d, const std::string& words) {
  return int(std::ranges::count_if(d.workspace().toasts.list, [&](const ui::Toasts::Toast& toast) {
    return toast.text.find(words) != std::string::npos;
  }));
}

TEST_F(WindowTest, TellsAnErrorOfTheDriverOnce) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const auto enable = reinterpret_cast<void (*)(unsigned)>(glfwGetProcAddress("glEnable"));
  enable(0xFFFF);  // there is no such thing
  d.frames(3);
  EXPECT_EQ(messagesWith(d, "driver reports an error"), 1);
  d.workspace().toasts.list.clear();
  enable(0xFFFF);
  d.frames(3);
  EXPECT_EQ(messagesWith(d, "driver reports an error"), 0);
}

// A volume that the driver cannot hold is a message, and the next one is shown.
TEST_F(WindowTest, TellsWhatTheDriverCannotHold) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  int most = 0;  // GL_MAX_3D_TEXTURE_SIZE
  reinterpret_cast<void (*)(unsigned, int*)>(glfwGetProcAddress("glGetIntegerv"))(0x8073, &most);
  if (most > 4096) GTEST_SKIP() << "a volume that this driver cannot hold is too large for a test";
  Geometry g;
  g.dims = {most + 1, 24, 24};
  g.spacing = {0.05, 0.5, 0.5};
  Volume<float> volume(g);
  for (std::size_t i = 0; i < volume.data.size(); ++i) volume.data[i] = float(i % 97) / 97;
  const fs::path file = folder / "long.nrrd";
  writeVolume(file, volume, Beam{});
  d.workspace().open(file);
  ASSERT_TRUE(d.wait([&] { return d.session().scan().volume->geometry.dims.x > most; }));
  d.frames(6);
  EXPECT_EQ(messagesWith(d, "graphics driver cannot hold a volume of"), 1);
  EXPECT_TRUE(d.knows("pane.coronal"));
  d.session().openPhantom();
  ASSERT_TRUE(d.wait([&] { return d.session().scan().volume->geometry.dims.x < most; }));
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_GT(share(d.screenshot("sonoskin_held"), d, "pane.axial", [](Colour c) { return c.g > 40; }), 0.01);
}

}  // namespace
}  // namespace sonoskin
