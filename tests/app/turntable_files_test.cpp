#include "app/batch/turntable_files.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;

Image grey(std::uint8_t level) {
  Image image{32, 16, {}};
  image.rgba.assign(4 * 32 * 16, level);
  return image;
}

TEST(TurntableFiles, AppearTogether) {
  const test::TempFolder folder;
  const fs::path name = folder / "face.png";
  EXPECT_EQ(TurntableFiles::taken(name), "");
  {
    TurntableFiles files(name, 3);
    files.write(0, grey(10));
    EXPECT_FALSE(fs::exists(folder / "face_001.png"));
  }  // cancelled
  EXPECT_FALSE(fs::exists(folder / "face_001.png"));
  TurntableFiles files(name, 3);
  for (int view = 0; view < 3; ++view) files.write(view, grey(std::uint8_t(60 * view + 10)));
  files.finish();
  ASSERT_GE(files.names().size(), 3u);
  EXPECT_EQ(files.names()[2], "face_003.png");
  EXPECT_EQ(readPng(folder / "face_002.png").rgba[0], 70);
  for (const std::string& made : files.names()) EXPECT_TRUE(fs::exists(folder / made)) << made;
  EXPECT_EQ(TurntableFiles::taken(name), "face_001.png");
  EXPECT_THROW(TurntableFiles(folder / "face.doc", 3), Error);
}

}  // namespace
}  // namespace sonoskin
