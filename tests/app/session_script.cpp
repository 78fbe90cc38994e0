#include "tests/app/session_script.h"

#include <algorithm>
#include <array>

#include "app/workspace/view_file.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"

namespace sonoskin::test {
namespace {

namespace fs = std::filesystem;

// A file dialog, by a name in the folder.
void answer(Player& p, const std::string& name) {
  ASSERT_TRUE(p.workspace().files.purpose) << name;
  p.hand({keyPress("ctrl+a"), typing((p.folder / name).string())});
  p.key("Return");
  EXPECT_FALSE(p.workspace().files.purpose) << p.workspace().files.complaint;
}

void open(Player& p) {
  const auto opened = p.session().opened();
  p.key("ctrl+o");
  answer(p, "scan.nrrd");
  ASSERT_TRUE(p.wait([&] { return p.session().opened() != opened; }));
  ASSERT_TRUE(p.untilIdle());
}

void dragTheCrossHair(Player& p) {
  const glm::dvec3 cursor = p.view().cursor;
  p.stroke({p.point("pane.axial", 0.5f, 0.5f), p.point("pane.axial", 0.55f, 0.45f)});
  EXPECT_NE(p.view().cursor, cursor);
}

void tune(Player& p) {
  p.click("step.classify");
  const auto values = [&] {
    const ClassificationOptions& c = p.session().parameters().classification;
    return std::array{c.isoValue, c.alpha, c.beta, c.gamma};
  };
  const auto before = values();
  for (const char* name : {"isoValue", "alpha", "beta", "gamma"}) {
    const std::string row = std::string("classification.") + name;
    p.stroke({p.point(row, 0.4f), p.point(row, 0.45f)});
  }
  for (std::size_t n = 0; n < before.size(); ++n) EXPECT_NE(values()[n], before[n]) << n;
  ASSERT_TRUE(p.untilIdle());
}

void crop(Player& p) {
  p.click("step.region");
  const auto cut = p.session().parameters().region.cutHigh;
  if (!p.knows("region.k.high")) p.click("foldout.Crop box");
  p.stroke({p.point("region.k.high", 0.97f), p.point("region.k.high", 0.9f)});
  EXPECT_NE(p.session().parameters().region.cutHigh, cut);
  ASSERT_TRUE(p.untilIdle());
}

void erase(Player& p) {
  p.key("e");
  p.stroke({p.point("pane.axial", 0.45f, 0.4f), p.point("pane.axial", 0.5f, 0.45f)});
  EXPECT_GT(p.session().erased().voxels(), 0u);
  p.key("Escape");
  ASSERT_TRUE(p.untilIdle());
}

void lassoUndoRedo(Player& p) {
  const ErasedParts& erased = p.session().erased();
  const std::size_t dab = erased.voxels();
  p.key("x");
  const auto at = [&](float x, float y) { return p.point("pane.space", x, y); };
  p.stroke({at(0.1f, 0.3f), at(0.25f, 0.3f), at(0.25f, 0.45f), at(0.1f, 0.45f)});
  const std::size_t both = erased.voxels();
  EXPECT_GT(both, dab) << "lasso";
  p.key("Escape");
  p.key("ctrl+z");
  EXPECT_EQ(erased.voxels(), dab) << "undo";
  p.key("ctrl+shift+z");
  EXPECT_EQ(erased.voxels(), both) << "redo";
  ASSERT_TRUE(p.untilIdle());
}

void reconstructAndCancel(Player& p) {
  // At once, for a fast machine is done within a slow frame.
  p.hand({keyPress("ctrl+Return"), keyPress("Escape")});
  ASSERT_TRUE(p.wait([&] { return !p.session().activity().busy; }));
  EXPECT_EQ(p.session().state(), DocumentState::stopped);
}

void reconstruct(Player& p) {
  const auto made = p.session().reconstructions();
  p.key("ctrl+Return");
  ASSERT_TRUE(p.wait([&] { return p.session().reconstructions() > made; }));
  ASSERT_TRUE(p.untilIdle());
  p.key("m");  // clay, whose picture does not wait for its light
  EXPECT_EQ(p.view().content, SpaceContent::mesh);
}

void takeAPartAway(Player& p) {
  p.key("p");
  ASSERT_TRUE(p.view().parts);
  const auto kept = [&] {
    return std::ranges::count_if(*p.session().results().verdicts, &PartVerdict::kept);
  };
  const auto before = kept();
  p.click(p.point("pane.space", 0.5f, 0.25f));
  ASSERT_TRUE(p.untilIdle());
  EXPECT_EQ(kept(), before - 1);
  p.key("Escape");
  ASSERT_TRUE(p.untilIdle());
}

void measure(Player& p) {
  const std::size_t before = p.view().measures.size();
  p.key("d");
  p.click(p.point("pane.axial", 0.4f, 0.4f));
  p.click(p.point("pane.axial", 0.5f, 0.5f));
  EXPECT_EQ(p.view().measures.size(), before + 1);
  p.key("Escape");
}

void savePicture(Player& p) {
  p.key("F12");
  p.click("picture.save");
  p.frames(3);
  answer(p, "picture.png");
  ASSERT_TRUE(p.wait([&] { return fs::exists(p.folder / "picture.png") && !p.session().saving(); }));
}

void saveMesh(Player& p) {
  p.key("ctrl+s");
  answer(p, "face.ply");
  ASSERT_TRUE(p.wait([&] { return fs::exists(p.folder / "face.recipe.json") && !p.session().saving(); }));
  p.frames(2);  // what was saved is noted
  EXPECT_FALSE(p.session().hasUnsavedWork());
}

constexpr std::array<ScriptPiece, 12> kScript{{{"open", open},
                                               {"drag the cross-hair", dragTheCrossHair},
                                               {"tune", tune},
                                               {"crop", crop},
                                               {"erase", erase},
                                               {"lasso, undo, redo", lassoUndoRedo},
                                               {"reconstruct, cancel", reconstructAndCancel},
                                               {"reconstruct", reconstruct},
                                               {"take a part away", takeAPartAway},
                                               {"measure", measure},
                                               {"save the picture", savePicture},
                                               {"save the mesh", saveMesh}}};

// The surface of what was tuned last is made whole, as it will be when the session is opened.
void changeSomething(Player& p) {
  p.click("step.classify");
  p.stroke({p.point("classification.beta", 0.45f), p.point("classification.beta", 0.4f)});
  ASSERT_TRUE(p.untilIdle());
  reconstruct(p);
}

}  // namespace

std::span<const ScriptPiece> sessionScript() { return kScript; }

Parameters scriptParameters() {
  Parameters parameters;
  parameters.phantom.dims = {156, 85, 62};
  parameters.mesh.resolution = 120;
  return parameters;
}

void beginScript(Player& p) {
  writeScan(p.folder / "scan.nrrd", makePhantomScan(scriptParameters().phantom));
  ASSERT_TRUE(p.untilIdle());
  p.workspace().settings.folder = p.folder;
}

void quitAndReopen(Player& p) {
  changeSomething(p);
  p.hand({moveTo({5, 5})});
  const Image before = p.stillPicture();
  const std::size_t measures = p.view().measures.size(), erased = p.session().erased().voxels();
  p.key("ctrl+q");
  ASSERT_TRUE(p.workspace().question) << "asked before the session is lost";
  const std::string views = writeViews(p.view());
  p.click("question.save");
  p.frames(3);
  answer(p, "whole.sonoskin");
  ASSERT_TRUE(p.wait([&] { return p.workspace().quit && !p.session().saving(); }));
  p.restart();
  ASSERT_TRUE(p.untilIdle());
  p.workspace().settings.folder = p.folder;
  p.key("ctrl+o");
  answer(p, "whole.sonoskin");
  ASSERT_TRUE(p.wait([&] { return p.session().results().mesh && !p.session().activity().busy; }));
  EXPECT_EQ(writeViews(p.view()), views);
  EXPECT_EQ(p.view().measures.size(), measures);
  EXPECT_EQ(p.session().erased().voxels(), erased);
  p.click("step.classify");
  p.hand({moveTo({5, 5})});
  const Image after = p.stillPicture();
  // The pixels along an outline are smoothed only where the machine is fast enough.
  for (const char* pane : {"pane.axial", "pane.sagittal", "pane.coronal", "pane.space"})
    EXPECT_LT(difference(before, after, p, pane), 0.004) << pane;
}

}  // namespace sonoskin::test
