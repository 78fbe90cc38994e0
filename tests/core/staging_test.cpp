#include "core/io/staging.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <random>
#include <set>

#include "core/io/atomic_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;
using test::fileText;
using test::TempFolder;

void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

TEST(Staging, IsHiddenPrivateAndNeverTheSame) {
  const TempFolder folder;
  const Staging a(folder.path()), b(folder.path());
  EXPECT_NE(a.path(), b.path());
  for (const Staging* s : {&a, &b}) {
    EXPECT_TRUE(s->path().filename().string().starts_with(".sonoskin-"));
    struct stat facts;
    ASSERT_EQ(::stat(s->path().c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777, 0700u);
  }
}

TEST(Staging, TakesObsoleteFilesAwayWithTheNewOnes) {
  const TempFolder folder;
  folder.write("old.stl", "old");
  folder.write("other.txt", "not ours");
  fs::create_directory(folder / "a-folder");
  Staging staging(folder.path());
  put(staging.path() / "new.ply", "new");
  staging.publish({"old.stl", "new.ply", "a-folder", "../old.stl", "missing"});
  EXPECT_EQ(fileText(folder / "new.ply"), "new");
  EXPECT_FALSE(fs::exists(folder / "old.stl"));
  EXPECT_TRUE(fs::exists(folder / "other.txt") && fs::is_directory(folder / "a-folder"));
}

TEST(Staging, RefusesBeforeAnythingIsChanged) {
  const TempFolder folder;
  folder.write("a.txt", "old");
  fs::create_directory(folder / "b.txt");
  Staging staging(folder.path());
  put(staging.path() / "a.txt", "new");
  put(staging.path() / "b.txt", "new");
  expectError([&] { staging.publish(); }, "not an ordinary file", Error::Kind::system);
  EXPECT_EQ(fileText(folder / "a.txt"), "old");
}

TEST(Staging, KeepsPermissionsAndLinksOfWhatIsReplaced) {
  const TempFolder folder;
  fs::create_directory(folder / "real");
  put(folder / "real/a.txt", "old");
  fs::permissions(folder / "real/a.txt", fs::perms(0640));
  fs::create_symlink("real/a.txt", folder / "a.txt");
  writeBytes(folder / "a.txt", "new", 3);
  EXPECT_TRUE(fs::is_symlink(folder / "a.txt"));
  EXPECT_EQ(fileText(folder / "real/a.txt"), "new");
  EXPECT_EQ(fs::status(folder / "real/a.txt").permissions(), fs::perms(0640));
  Staging staging(folder.path());
  put(staging.path() / "a.txt", "set");
  staging.publish();
  EXPECT_TRUE(fs::is_symlink(folder / "a.txt"));
  EXPECT_EQ(fileText(folder / "real/a.txt"), "set");
}

// What a program that was killed leaves: gone with the next output. What is in use stays.
TEST(Staging, RemovesWhatKilledProgramsLeft) {
  const TempFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    const Staging left(folder.path());
    put(left.path() / "half.ply", "half");
    ::_exit(0);  // without destructors, as by a kill
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(folder.entries(), 1);
  const Staging inUse(folder.path());
  EXPECT_EQ(folder.entries(), 1);  // the child's is gone, this one there
  writeBytes(folder / "a.txt", "x", 1);
  EXPECT_TRUE(fs::exists(inUse.path()));
  EXPECT_EQ(folder.entries(), 2);
}

// A link that somebody planted under such a name is neither followed nor removed.
TEST(Staging, LeavesPlantedLinksAlone) {
  const TempFolder folder;
  const TempFolder elsewhere;
  elsewhere.write("precious.txt", "x");
  fs::create_directory_symlink(elsewhere.path(), folder / ".sonoskin-0123456789abcdef0123456789abcdef");
  writeBytes(folder / "a.txt", "x", 1);
  EXPECT_TRUE(fs::exists(elsewhere / "precious.txt"));
  EXPECT_TRUE(fs::is_symlink(folder / ".sonoskin-0123456789abcdef0123456789abcdef"));
}

// A folder of that name that was copied or unpacked here with a list in it: its list is not followed. What only begins with
// the same letters is nobody's business.
TEST(Staging, FollowsNoListThatIsNotItsOwn) {
  const TempFolder folder;
  folder.write("precious.txt", "x");
  folder.write("mesh.ply", "good");
  const fs::path planted = folder / ".sonoskin-0123456789abcdef0123456789abcdef",
                 notes = folder / ".sonoskin-notes";
  for (const fs::path& made : {planted, notes}) {
    fs::create_directory(made);
    put(made / "mesh.ply", "evil");
    put(made / ".sonoskin-publish",
        made == planted ? "12\n-precious.txt\n+mesh.ply\n" : "-precious.txt\n+mesh.ply\n");
  }
  writeBytes(folder / "a.txt", "x", 1);
  EXPECT_TRUE(fs::exists(folder / "precious.txt"));
  EXPECT_EQ(fileText(folder / "mesh.ply"), "good");
  EXPECT_EQ(fileText(notes / "mesh.ply"), "evil");
}

// The system would take such a name for the part before the zero, "." here, and refuse it at every start again.
TEST(Staging, DropsNamesWithZerosInAJournal) {
  const TempFolder folder;
  const fs::path left = folder / ".sonoskin-00000000000000000000000000000000";
  fs::create_directory(left);
  put(left / "a.ply", "new");
  struct stat facts;
  ASSERT_EQ(::stat(left.c_str(), &facts), 0);
  put(left / ".sonoskin-publish", std::to_string(facts.st_ino) + std::string("\n+.\0x\n+a.ply\n", 13));
  finishInterrupted(folder.path());
  EXPECT_FALSE(fs::exists(left));
  EXPECT_EQ(fileText(folder / "a.ply"), "new");
}

// Killed at fifty moments of publishing sets one after the other, the next start finds one set or the other, never a
// mixture, and none of the files that a set takes away.
TEST(Staging, ASetIsWholeWheneverItsMakerIsKilled) {
  constexpr int kFiles = 12, kMoments = 50;
  const TempFolder folder;
  std::mt19937 random(7);
  for (int moment = 0; moment < kMoments; ++moment) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int set = 0;; ++set) {
        Staging staging(folder.path());
        for (int f = 0; f < kFiles; ++f)
          put(staging.path() / std::to_string(f), std::to_string(1000 * moment + set));
        put(staging.path() / (set % 2 ? "odd" : "even"), "");
        staging.publish({set % 2 ? "even" : "odd"});
      }
    }
    ::usleep(useconds_t(2000 + random() % 12000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    finishInterrupted(folder.path());
    std::set<std::string> found;
    for (int f = 0; f < kFiles; ++f) found.insert(fileText(folder / std::to_string(f)));
    EXPECT_EQ(found.size(), 1u) << "moment " << moment;
    EXPECT_FALSE(fs::exists(folder / "odd") && fs::exists(folder / "even")) << "moment " << moment;
    EXPECT_LE(folder.entries(), kFiles + 1) << "moment " << moment;
  }
}

}  // namespace
}  // namespace sonoskin
