#include "core/io/file_bytes.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;
using test::TempFolder;

// Each sentence tells the one cause that it is.
TEST(FileBytes, SayWhyAFileCannotBeRead) {
  const TempFolder folder;
  expectError([&] { fileSize(folder / "none"); }, "There is no file");
  expectError([&] { fileSize(folder.path()); }, "is a folder, not a file");
  expectError([&] { fileSize(folder.write("empty", "")); }, "is empty");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  expectError([&] { fileSize(folder / "pipe"); }, "not an ordinary file");
  fs::create_symlink(folder / "loop", folder / "loop");
  expectError([&] { fileSize(folder / "loop"); }, "leads to itself");
  expectError([&] { readText(folder.write("long", std::string(3 << 20, 'x')), 1 << 20); }, "more than 1 MB");
}

// As a user who may not look into the folder: that is no missing file.
TEST(FileBytes, ForbiddenIsNotMissing) {
  const TempFolder folder;
  fs::create_directory(folder / "closed");
  folder.write("closed/a.nrrd", "x"), folder.write("b.nrrd", "x");
  fs::permissions(folder.path(), fs::perms(0755));
  fs::permissions(folder / "closed", fs::perms(0000));
  fs::permissions(folder / "b.nrrd", fs::perms(0000));
  const bool root = ::geteuid() == 0;
  if (root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  expectError([&] { fileSize(folder / "closed/a.nrrd"); }, "permissions of its folder");
  expectError([&] { readBytes(folder / "b.nrrd"); }, "check its permissions");
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  fs::permissions(folder / "closed", fs::perms(0700));
}

}  // namespace
}  // namespace sonoskin
