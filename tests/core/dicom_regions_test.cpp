// Slices of ultrasound that each say where in them the picture lies: text that is burnt in around it is blanked in all.
#include <gtest/gtest.h>

#include "core/base/log.h"
#include "core/io/dicom/dicom_series.h"
#include "tests/support/dicom.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::DicomBytes;
using test::DicomImage;
using test::TempFolder;

constexpr int kColumns = 10, kRows = 12, kSlices = 4, kPicture = 100, kText = 255;

std::string bytesOf(const void* value, std::size_t bytes) { return {static_cast<const char*>(value), bytes}; }

// A picture from row `top` to the last one, of 1 mm pixels [DICOM PS3.3, C.8.5.5].
test::DicomText regionFrom(std::uint32_t top) {
  constexpr double kCentimetres = 0.1;
  const std::uint32_t right = kColumns - 1, bottom = kRows - 1, left = 0;
  DicomBytes item;
  item.number(0x18, 0x6012, "US", 1), item.number(0x18, 0x6014, "US", 1);
  item.element(0x18, 0x6018, "UL", bytesOf(&left, 4)), item.element(0x18, 0x601A, "UL", bytesOf(&top, 4));
  item.element(0x18, 0x601C, "UL", bytesOf(&right, 4));
  item.element(0x18, 0x601E, "UL", bytesOf(&bottom, 4));
  item.number(0x18, 0x6024, "US", 3), item.number(0x18, 0x6026, "US", 3);
  item.element(0x18, 0x602C, "FD", bytesOf(&kCentimetres, 8));
  item.element(0x18, 0x602E, "FD", bytesOf(&kCentimetres, 8));
  return {0x18, 0x6011, "SQ", test::dicomItem(item.bytes)};
}

// tops: the first row of each slice's picture, which has text in all rows above; -1: the slice does not tell, and has text in
// its first row.
struct Series : TempFolder {
  explicit Series(const std::vector<int>& tops) {
    for (int k = 0; k < kSlices; ++k) {
      const int top = tops[std::size_t(k)];
      DicomImage image;
      image.columns = kColumns, image.rows = kRows, image.number = k + 1, image.place = k;
      image.allocated = image.stored = 8, image.modality = "US", image.spacing = "1\\1";
      for (int j = 0; j < kRows; ++j)
        image.numbers.insert(image.numbers.end(), kColumns, j < std::abs(top) ? kText : kPicture);
      if (top >= 0) image.others.push_back(regionFrom(std::uint32_t(top)));
      image.others.push_back({0x28, 0x301, "CS", "YES"});
      write(std::to_string(k) + ".dcm", dicomFile(image));
    }
  }
  LoadedVolume blanked() const {
    ReadOptions options;
    options.regionOnly = true;
    return readDicomSeries(path(), options);
  }
};

void expectBlanked(const LoadedVolume& v, const std::vector<int>& tops) {
  ASSERT_EQ(v.stored.geometry.dims, glm::ivec3(kColumns, kRows, kSlices));
  ASSERT_EQ(v.stored.type, NumberType::uint8);
  for (int k = 0; k < kSlices; ++k)
    for (int j = 0; j < kRows; ++j)
      for (int i = 0; i < kColumns; ++i)
        ASSERT_EQ(int(v.numbers[v.stored.geometry.index(i, j, k)]), j < tops[std::size_t(k)] ? 0 : kPicture)
            << i << " " << j << " " << k;
}

TEST(DicomRegions, EachSliceIsBlankedOutsideOfItsOwn) {
  const LogRecord record;
  for (const std::vector<int>& tops : {std::vector{0, 4, 4, 4}, {5, 2, 0, 7}}) {
    const Series series(tops);
    expectBlanked(series.blanked(), tops);
  }
  EXPECT_TRUE(record.sentences(LogLevel::warning).empty());
}

TEST(DicomRegions, ASliceWithoutOneIsBlankedAsTheOthers) {
  const LogRecord record;
  expectBlanked(Series({-1, 4, 1, 2}).blanked(), {1, 4, 1, 2});
  ASSERT_EQ(record.sentences(LogLevel::warning).size(), 1u);
  EXPECT_NE(record.sentences(LogLevel::warning)[0].find("in 1 of 4 frames is not told"), std::string::npos);
}

TEST(DicomRegions, WithoutAnyNothingIsBlankedWhichIsSaid) {
  const LogRecord record;
  const LoadedVolume v = Series({-1, -1, -1, -1}).blanked();
  EXPECT_EQ(int(v.numbers[0]), kText);
  ASSERT_EQ(record.sentences(LogLevel::warning).size(), 2u);
  EXPECT_NE(record.sentences(LogLevel::warning)[0].find("nothing is blanked"), std::string::npos);
  EXPECT_NE(record.sentences(LogLevel::warning)[1].find("may name the patient"), std::string::npos);
}

}  // namespace
}  // namespace sonoskin
