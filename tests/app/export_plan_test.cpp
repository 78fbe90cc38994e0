// What the export dialog knows without a window: formats, files beside, what is there already, and the command.
#include "app/panels/export_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "app/document/command_text.h"
#include "tests/app/cli_support.h"
#include "tests/app/session_support.h"

namespace sonoskin::ui {
namespace {

std::size_t itemNamed(const std::string& id) {
  const auto found = std::ranges::find(exportItems(), id, &ExportItem::id);
  return std::size_t(found - exportItems().begin());
}

ExportPlan planOf(const std::string& id, const std::filesystem::path& folder) {
  ExportPlan plan;
  chooseItem(plan, itemNamed(id));
  plan.folder = folder;
  return plan;
}

std::vector<std::string> namesOf(const ExportPlan& plan) {
  std::vector<std::string> names;
  for (const ExportFile& file : exportFiles(plan, {})) names.push_back(file.name + (file.exists ? "!" : ""));
  return names;
}

using Names = std::vector<std::string>;

TEST(ExportPlan, TellsAllFilesAndWhichAreThere) {
  const test::TempFolder folder;
  ExportPlan plan = planOf("mesh", folder.path());
  EXPECT_EQ(namesOf(plan), (Names{"surface.ply", "surface.recipe.json"}));
  folder.write("surface.recipe.json", "{}");
  EXPECT_EQ(namesOf(plan), (Names{"surface.ply", "surface.recipe.json!"}));
  plan = planOf("skin", folder.path());
  chooseEnding(plan, ".obj");
  EXPECT_EQ(namesOf(plan), (Names{"skin.obj", "skin.mtl", "skin_colour.png", "skin_normal.png",
                                  "skin_roughness.png", "skin.recipe.json"}));
  plan = planOf("turntable", folder.path());
  EXPECT_EQ(namesOf(plan), (Names{"turntable_001.png", "turntable.mp4", "turntable.recipe.json"}));
  EXPECT_EQ(exportFiles(plan, {.views = 36}).front().more, "turntable_036.png");
}

// A name that no writer knows does not become another one behind the person's back.
TEST(ExportPlan, AnEndingThatCannotBeWrittenIsSaid) {
  Workspace workspace{test::tinySurface()};
  workspace.session.openPhantom();
  ASSERT_TRUE(test::wait(workspace.session));
  const test::TempFolder folder;
  ExportPlan plan = planOf("scan", folder.path());
  EXPECT_EQ(complaintOf(plan, workspace), "");
  plan.name = "face.xyz";
  EXPECT_NE(complaintOf(plan, workspace).find(".nrrd, .mha"), std::string::npos);
  EXPECT_EQ(plan.path().filename(), "face.xyz");
  chooseEnding(plan, ".nii.gz");
  EXPECT_EQ(plan.name, "face.xyz.nii.gz") << "what the person sees before it is written";
  EXPECT_EQ(endingOf(plan), ".nii.gz");
  EXPECT_EQ(complaintOf(plan, workspace), "");
  plan.folder = folder / "nowhere";
  EXPECT_NE(complaintOf(plan, workspace).find("does not exist"), std::string::npos);
  EXPECT_NE(complaintOf(planOf("mesh", folder.path()), workspace).find("reconstruct"), std::string::npos);
}

TEST(ExportPlan, EveryItemHasFormatsWithASentenceEach) {
  for (const ExportItem& item : exportItems()) {
    EXPECT_FALSE(exportFormats(item).empty()) << item.id;
    for (const ExportFormat& format : exportFormats(item)) {
      EXPECT_FALSE(format.keeps.empty()) << item.id << format.ending;
      ExportPlan plan = planOf(item.id, "/");
      chooseEnding(plan, format.ending);
      EXPECT_EQ(endingOf(plan), format.ending) << item.id;
    }
  }
}

TEST(ExportPlan, FrameAndUnitAreChosenWhereTheFormatLeavesThemOpen) {
  ExportPlan plan = planOf("mesh", "/");
  for (const char* open : {".ply", ".stl", ".obj", ".vtp"}) {
    chooseEnding(plan, open);
    EXPECT_TRUE(placementChoosable(plan)) << open;
  }
  for (const char* fixed : {".glb", ".3mf", ".dcm"}) {
    chooseEnding(plan, fixed);
    EXPECT_FALSE(placementChoosable(plan)) << fixed;
    EXPECT_FALSE(placementWords(plan).empty());
  }
}

// The command that the dialog shows writes the same file.
TEST(ExportPlan, TheCommandWritesTheSameSurface) {
  Workspace workspace{test::tinySurface()};
  Session& session = workspace.session;
  session.openPhantom();
  ASSERT_TRUE(test::wait(session));
  session.reconstruct();
  ASSERT_TRUE(test::wait(session));
  const test::TempFolder folder;
  ExportPlan plan = planOf("mesh", folder.path());
  plan.placement = {MeshFrame::ras, MeshUnit::metres};
  session.saveMesh(plan.path(), plan.placement);
  ASSERT_TRUE(test::wait(session));
  std::istringstream words(exportCommand(plan, workspace));
  std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
  ASSERT_EQ(arguments.front(), "sonoskin");
  arguments.erase(arguments.begin());
  const test::ProgramResult result = test::sonoskin(arguments);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(test::fileText(folder / "surface/mesh.ply"), test::fileText(folder / "surface.ply"));
  EXPECT_NE(test::fileText(folder / "surface.ply").find("units m, SPACE=RAS"), std::string::npos);
}

TEST(CommandText, QuotesWhatAShellWouldTakeForSomethingElse) {
  EXPECT_EQ(CommandText("run").word("a b").option("--out", "it's").flag("--json").text(),
            "sonoskin run 'a b' --out 'it'\\''s' --json");
  EXPECT_EQ(CommandText("run").word("").word("$HOME;x").text(), "sonoskin run '' '$HOME;x'");
  EXPECT_EQ(CommandText("run").word("/data/scan-1.nrrd").text(), "sonoskin run /data/scan-1.nrrd");
}

}  // namespace
}  // namespace sonoskin::ui
