#include "core/io/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/io/png_encoder.h"
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

// Noise, flat areas and slopes, so that every filter has rows that it is best for.
Image mixedRows(int width, int height) {
  Image image{width, height, {}};
  unsigned state = 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      state = state * 1664525u + 1013904223u;
      const int noise = int(state >> 28);
      const int kinds[] = {3 * x, 5 * (y / 6), (x + y) / 2 + noise, 2 * x + 3 * y, int(state >> 24)};
      for (int c = 0; c < 3; ++c) image.rgba.push_back(std::uint8_t(kinds[y % 5] + 40 * c));
      image.rgba.push_back(255);
    }
  return image;
}

TEST(Png, OpaquePicturesHaveThreeChannelsAndComeBack) {
  const TempFolder folder;
  Image image = mixedRows(61, 40);
  const std::vector<std::uint8_t> opaque = encodePng(image);
  EXPECT_EQ(opaque[25], 2);
  writePng(folder / "a.png", image);
  EXPECT_EQ(readPng(folder / "a.png").rgba, image.rgba);
  image.rgba[7] = 254;
  EXPECT_EQ(encodePng(image)[25], 6);
  writePng(folder / "b.png", image);
  EXPECT_EQ(readPng(folder / "b.png").rgba, image.rgba);
}

// What the format's formulas for undoing a filter give of each row, one byte after the other, is the picture.
TEST(Png, FiltersAreUndone) {
  const Image image = mixedRows(19, 35);
  const int row = 3 * image.width;
  const std::vector<std::uint8_t> filtered = filterRows(image, 3);
  ASSERT_EQ(filtered.size(), std::size_t((row + 1) * image.height));
  std::vector<int> pixels(std::size_t(row * image.height)), used(5);
  for (int y = 0; y < image.height; ++y) {
    const int filter = filtered[std::size_t(y * (row + 1))];
    ASSERT_LE(filter, 4);
    ++used[std::size_t(filter)];
    for (int i = 0; i < row; ++i) {
      const auto at = [&](int dy, int dx) {
        return y < dy || i < dx ? 0 : pixels[std::size_t((y - dy) * row + i - dx)];
      };
      const int left = at(0, 3), up = at(1, 0), corner = at(1, 3), p = left + up - corner;
      const int a = std::abs(p - left), b = std::abs(p - up), c = std::abs(p - corner);
      const int nearest = a <= b && a <= c ? left : b <= c ? up : corner;
      const int foretold[] = {0, left, up, (left + up) / 2, nearest};
      const int value = (filtered[std::size_t(y * (row + 1) + 1 + i)] + foretold[filter]) & 255;
      pixels[std::size_t(y * row + i)] = value;
      ASSERT_EQ(value, image.rgba[std::size_t(4 * (y * image.width + i / 3) + i % 3)]) << y << " " << i;
    }
  }
  EXPECT_GE(std::count_if(used.begin(), used.end(), [](int n) { return n > 0; }), 3);
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
  bytes.resize(good.find("IDAT") + 6);  // which ends behind its name
  expectError([&] { readPng(folder.write("d.png", bytes)); }, "declares more than it holds");
}

TEST(Png, WhatFollowsTheEndIsNoPart) {
  const TempFolder folder;
  writePng(folder / "a.png", gradient(8, 8));
  const std::string more = test::fileText(folder / "a.png") + "\x7f more than eight bytes";
  EXPECT_EQ(readPng(folder.write("b.png", more)).rgba, readPng(folder / "a.png").rgba);
}

}  // namespace
}  // namespace sonoskin
