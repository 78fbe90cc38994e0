#include "app/widgets/file_dialog.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/cli_support.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::fileText;
using test::sonoskin;
using test::TempFolder;
using ui::FilePurpose;

constexpr FilePurpose kPurposes[] = {
    FilePurpose::open,       FilePurpose::findVolume,  FilePurpose::openSession, FilePurpose::saveSession,
    FilePurpose::openErased, FilePurpose::saveErased,  FilePurpose::openRecipe,  FilePurpose::saveRecipe,
    FilePurpose::saveMesh,   FilePurpose::savePrint,   FilePurpose::saveScan,    FilePurpose::saveClassified,
    FilePurpose::saveSkin,   FilePurpose::saveLitSkin, FilePurpose::savePicture, FilePurpose::saveTurntable};

// A dialog that lists and takes what the readers and writers take: nothing else, and all of it.
TEST(FileDialog, OffersWhatCanBeReadAndWritten) {
  const TempFolder folder;
  for (const FilePurpose purpose : kPurposes) {
    const FileKind kind = purposeText(purpose).kind;
    SCOPED_TRACE(purposeText(purpose).title);
    for (const std::string& ending : extensionsOf(kind)) folder.write("a" + ending, "x");
    folder.write("a.xyz", "x"), folder.write("a.vol", "x"), folder.write("a.dat", "x");
    ui::FileDialog dialog;
    dialog.ask(purpose, folder.path(), "");
    std::vector<std::string> listed, expected;
    for (const ui::FileEntry& entry : dialog.entries) listed.push_back(entry.name);
    for (const std::string& ending : extensionsOf(kind)) expected.push_back("a" + ending);
    std::ranges::sort(expected);
    std::ranges::sort(listed);
    EXPECT_EQ(listed, expected);
    for (const auto& entry : fs::directory_iterator(folder.path())) fs::remove(entry);
  }
}

TEST(FileDialog, GivesNamesWithoutAnEndingTheUsualOne) {
  const TempFolder folder;
  for (const FilePurpose purpose : kPurposes) {
    const ui::FilePurposeText text = purposeText(purpose);
    if (!text.save) continue;
    ui::FileDialog dialog;
    dialog.ask(purpose, folder.path(), "face");
    const auto path = accept(dialog);
    ASSERT_TRUE(path) << dialog.complaint;
    EXPECT_EQ(path->filename(), "face" + extensionsOf(text.kind).front());
  }
}

TEST(FileDialog, RefusesOtherEndingsAndNamesThoseThatAre) {
  const TempFolder folder;
  for (const FilePurpose purpose : kPurposes) {
    const ui::FilePurposeText text = purposeText(purpose);
    if (!text.save) continue;
    SCOPED_TRACE(text.title);
    for (const char* name : {"face.xyz", "face.vol", "face.ply.txt"}) {
      ui::FileDialog dialog;
      dialog.ask(purpose, folder.path(), name);
      EXPECT_FALSE(accept(dialog)) << name;
      for (const std::string& ending : extensionsOf(text.kind))
        EXPECT_NE(dialog.complaint.find(ending), std::string::npos) << dialog.complaint;
    }
  }
}

TEST(FileDialog, AsksBeforeAFileIsReplaced) {
  const TempFolder folder;
  folder.write("face.ply", "x");
  ui::FileDialog dialog;
  dialog.ask(FilePurpose::saveMesh, folder.path(), "face");
  EXPECT_FALSE(accept(dialog));
  EXPECT_NE(dialog.complaint.find("Replace"), std::string::npos);
  EXPECT_EQ(accept(dialog), folder / "face.ply");
}

// All that is written is asked for, whoever made it.
TEST(FileDialog, AsksBeforeWhatLiesBesideIsReplaced) {
  const TempFolder folder;
  folder.write("face.recipe.json", R"({"sonoskin": "of somebody else"})");
  ui::FileDialog dialog;
  dialog.ask(FilePurpose::saveMesh, folder.path(), "face");
  EXPECT_FALSE(accept(dialog));
  EXPECT_NE(dialog.complaint.find("face.recipe.json"), std::string::npos) << dialog.complaint;
  EXPECT_EQ(accept(dialog), folder / "face.ply");
  folder.write("skin.mtl", "x");
  dialog.ask(FilePurpose::saveSkin, folder.path(), "skin.obj");
  EXPECT_FALSE(accept(dialog));
  EXPECT_NE(dialog.complaint.find("skin.mtl"), std::string::npos) << dialog.complaint;
  folder.write("baby_0003.ply", "x"), folder.write("baby_0004.ply", "x"), folder.write("baby_x.ply", "x");
  dialog.ask(FilePurpose::saveSequence, folder.path(), "baby.ply");
  EXPECT_FALSE(accept(dialog));
  EXPECT_NE(dialog.complaint.find("baby_0003.ply and baby_0004.ply"), std::string::npos) << dialog.complaint;
  dialog.ask(FilePurpose::saveRecipe, folder.path(), "other.json");
  EXPECT_TRUE(accept(dialog));
}

// Help and README are made from the same table.
TEST(FileFormats, AreToldAlikeEverywhere) {
  const std::string table = sonoskin({"info", "--formats"}).out;
  EXPECT_EQ(table, formatTable());
  EXPECT_NE(fileText(SONOSKIN_README).find(table), std::string::npos)
      << "README.md is out of date: run tests/tools/update_tables.py build/release/sonoskin";
  const auto expectAll = [](const std::vector<std::string>& words, FileKind kind) {
    const std::string help = sonoskin(words).out;
    for (const std::string& word : extensionWords(kind))
      EXPECT_NE(help.find(word), std::string::npos) << words.front() << ": " << word;
  };
  expectAll({"--help"}, FileKind::readVolume);
  expectAll({"--help"}, FileKind::readMesh);
  expectAll({"run", "--help"}, FileKind::writtenMesh);
  expectAll({"phantom", "--help"}, FileKind::writtenVolume);
  expectAll({"phantom", "--help"}, FileKind::writtenMesh);
  expectAll({"render", "--help"}, FileKind::picture);
  expectAll({"render", "--help"}, FileKind::texturedMesh);
}

TEST(FileFormats, OutputsOfOtherEndingsAreRefusedBeforeAnyWork) {
  const TempFolder folder;
  const auto expectAll = [&](const std::vector<std::string>& words, FileKind kind) {
    const test::ProgramResult result = sonoskin(words);
    EXPECT_EQ(result.status, 2) << result.err;
    for (const std::string& ending : extensionsOf(kind))
      EXPECT_NE(result.err.find(ending), std::string::npos) << result.err;
  };
  const std::string other = (folder / "a.xyz").string();
  expectAll({"phantom", "--out", other}, FileKind::writtenVolume);
  expectAll({"phantom", "--out", (folder / "a.nrrd").string(), "--truth", other}, FileKind::writtenMesh);
  expectAll({"render", "phantom", "--out", other}, FileKind::picture);
  expectAll({"render", "phantom", "--out", other, "--bake", "colour"}, FileKind::texturedMesh);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace sonoskin
