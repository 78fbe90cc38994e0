#include "app/batch/picture_writer.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

TEST(PictureWriter, WritesAllAndTellsWhatItCannot) {
  const test::TempFolder folder;
  PictureWriter writer;
  const auto grey = [](std::uint8_t value) { return Image{40, 30, std::vector<std::uint8_t>(4800, value)}; };
  for (int i = 0; i < 6; ++i) writer.write(folder / (std::to_string(i) + ".png"), grey(std::uint8_t(40 * i)));
  writer.finish();
  for (int i = 0; i < 6; ++i) EXPECT_EQ(readPng(folder / (std::to_string(i) + ".png")).rgba[0], 40 * i);
  writer.write(folder / "none/a.png", grey(1));
  EXPECT_THROW(writer.finish(), Error);
}

}  // namespace
}  // namespace sonoskin
