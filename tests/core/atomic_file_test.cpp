#include "core/io/atomic_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/progress.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::fileText;
using test::TempFolder;

TEST(WriteAtomically, ReplacesTheTargetAndLeavesNothingElse) {
  const TempFolder folder;
  const auto target = folder.write("a.nii.gz", "old");
  writeAtomically(target, [&](const std::filesystem::path& temporary) {
    EXPECT_EQ(temporary.parent_path().parent_path(), target.parent_path());
    EXPECT_TRUE(temporary.filename().string().ends_with(".nii.gz"));
    std::ofstream(temporary) << "new";
    EXPECT_EQ(fileText(target), "old");
  });
  EXPECT_EQ(fileText(target), "new");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteAtomically, KeepsTheOldFileWhenTheWriterFailsOrIsCancelled) {
  const TempFolder folder;
  const auto target = folder.write("a.txt", "old");
  EXPECT_THROW(writeAtomically(target,
                               [](const std::filesystem::path& temporary) {
                                 std::ofstream(temporary) << "half";
                                 throw Cancelled{};
                               }),
               Cancelled);
  EXPECT_EQ(fileText(target), "old");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteAtomically, RefusesFoldersDevicesAndMissingFolders) {
  const TempFolder folder;
  const auto system = Error::Kind::system;
  expectError([&] { writeBytes(folder / "no/a.txt", "x", 1); }, "does not exist", system);
  expectError([&] { writeBytes(folder.path(), "x", 1); }, "not an ordinary file", system);
  expectError([&] { writeBytes("/dev/null", "x", 1); }, "not an ordinary file", system);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WriteBytes, TellsWhenTheDiskIsFull) {
  // /dev/full is a device and is refused as such; a name of 300 letters is what a file system refuses to
  // make.
  const TempFolder folder;
  expectError([&] { writeBytes(folder / std::string(300, 'x'), "x", 1); }, "", Error::Kind::system);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(OutputFolder, ShowsAllFilesOnCommitOnly) {
  const TempFolder folder;
  const auto out = folder / "deep/er";
  {
    OutputFolder set(out);
    std::ofstream(set.file("a.txt")) << "a";
    std::ofstream(set.file("b.txt")) << "b";
    EXPECT_FALSE(std::filesystem::exists(out / "a.txt"));
    set.commit();
  }
  EXPECT_EQ(fileText(out / "a.txt"), "a");
  EXPECT_EQ(fileText(out / "b.txt"), "b");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 2);
}

TEST(OutputFolder, WithoutCommitLeavesTheWorldAsItWas) {
  const TempFolder folder;
  { std::ofstream(OutputFolder(folder / "new/one").file("a.txt")) << "a"; }
  EXPECT_EQ(folder.entries(), 0);
  const auto old = folder.write("a.txt", "old");
  { std::ofstream(OutputFolder(folder.path()).file("a.txt")) << "new"; }
  EXPECT_EQ(fileText(old), "old");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(OutputFolder, RefusesNamesThatLeadElsewhere) {
  const TempFolder folder;
  OutputFolder set(folder.path());
  expectError([&] { set.file("../a.txt"); }, "plain file name");
  expectError([&] { set.file(".."); }, "plain file name");
  expectError([&] { OutputFolder(folder.write("file", "x")); }, "cannot be made", Error::Kind::system);
}

// The child process ends in the middle of its work; what it had begun is gone, what was there before is not.
TEST(AbandonOutput, LeavesNothingUnfinished) {
  namespace fs = std::filesystem;
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // other tests may have left threads behind
  const TempFolder temp;
  const fs::path kept = temp.path() / "kept";
  fs::create_directory(kept);
  writeBytes(kept / "a.txt", "old", 3);
  EXPECT_EXIT(
      {
        OutputFolder fresh(temp.path() / "new" / "deeper");
        OutputFolder existing(kept);
        std::ofstream(fresh.file("a.txt")) << "half";
        std::ofstream(existing.file("a.txt")) << "half";
        writeAtomically(kept / "b.txt", [](const fs::path& temporary) {
          std::ofstream(temporary) << "half";
          abandonOutput(4);
        });
      },
      ::testing::ExitedWithCode(4), "");
  EXPECT_FALSE(fs::exists(temp.path() / "new"));
  EXPECT_EQ(std::distance(fs::directory_iterator(kept), fs::directory_iterator()), 1);
  EXPECT_EQ(fs::file_size(kept / "a.txt"), 3u);
}

}  // namespace
}  // namespace sonoskin
