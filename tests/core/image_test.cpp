#include "core/io/image.h"

#include <gtest/gtest.h>

#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::TempFolder;

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int c : {x, y, x ^ y, 255 - x}) image.rgba.push_back(std::uint8_t(c));
  return image;
}

TEST(Png, KeepsEveryPixelAndTheOrderOfRows) {
  const TempFolder folder;
  const Image image = gradient(37, 21);
  writePng(folder / "a.png", image);
  const Image read = readPng(folder / "a.png");
  EXPECT_EQ(read.width, 37);
  EXPECT_EQ(read.height, 21);
  EXPECT_EQ(read.rgba, image.rgba);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(Png, RefusesWhatIsNoPicture) {
  const TempFolder folder;
  expectError([&] { writePng(folder / "a.png", Image{2, 2, {1, 2, 3}}); }, "2 x 2 pixels with 3 bytes");
  expectError([&] { readPng(folder / "none.png"); }, "no file");
  expectError([&] { readPng(folder.write("empty.png", "")); }, "empty");
  expectError([&] { readPng(folder.write("text.png", "hello, world")); }, "not a PNG");
  expectError([&] { readPng(folder.path()); }, "is a folder, not a file");
}

TEST(Png, RefusesTruncatedAndHugePictures) {
  const TempFolder folder;
  writePng(folder / "a.png", gradient(64, 64));
  std::string bytes = test::fileText(folder / "a.png");
  expectError([&] { readPng(folder.write("b.png", bytes.substr(0, bytes.size() / 2))); }, "damaged");
  bytes[16] = 0x7f;  // the width's most significant byte
  expectError([&] { readPng(folder.write("c.png", bytes)); }, "make it smaller");
}

// What a header of some bytes asks for is held against the file's size before memory is taken for it.
TEST(Png, TakesNoMoreMemoryThanTheFileCanFill) {
  const TempFolder folder;
  writePng(folder / "a.png", gradient(8, 8));
  const std::string good = test::fileText(folder / "a.png");
  std::string bytes = good;
  bytes[18] = bytes[22] = 0x3f;  // 16136 x 16136 pixels
  expectError([&] { readPng(folder.write("b.png", bytes)); }, "declares more than it holds");
  bytes = good;
  bytes[good.find("IDAT") - 4] = 0x38;  // a part of 939 MB
  expectError([&] { readPng(folder.write("c.png", bytes)); }, "declares more than it holds");
}

}  // namespace
}  // namespace sonoskin
