// What the numbers of a DICOM file mean: sign, bits, scale and padding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/io/reader_process.h"
#include "core/io/reader_wire.h"
#include "core/io/volume_loader.h"
#include "core/io/volume_reader.h"
#include "core/io/volume_writer.h"
#include "tests/support/dicom.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::DicomImage;
using test::expectError;
using test::TempFolder;

constexpr int kSide = 16;

// A recorded ball of 20 to 200 whose outside is told: -1 here.
std::vector<std::int32_t> ball() {
  std::vector<std::int32_t> numbers;
  std::uint64_t n = 0;
  for (int k = 0; k < kSide; ++k)
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const double noise = test::noise(n++);
        const bool inside = glm::length(glm::dvec3(i, j, k) - 7.5) < 8.5;  // cut off by the sides
        numbers.push_back(inside ? 20 + int(180 * noise) : -1);
      }
  return numbers;
}

// The ball as a series, each number changed by `stored(number, slice)`, with what `describe(image, slice)` sets.
template <class Stored, class Describe>
fs::path series(const TempFolder& folder, const Stored& stored, const Describe& describe) {
  const std::vector<std::int32_t> numbers = ball();
  constexpr int kSlice = kSide * kSide;
  for (int k = 0; k < kSide; ++k) {
    DicomImage image;
    image.columns = image.rows = kSide;
    image.number = k + 1, image.place = 0.5 * k;
    describe(image, k);
    for (int v = 0; v < kSlice; ++v) image.numbers.push_back(stored(numbers[std::size_t(k * kSlice + v)], k));
    folder.write(fmt::format("{:03}.dcm", k), dicomFile(image));
  }
  return folder.path();
}

// The same ball in bytes with zeros outside, as another format has it.
Volume<float> expected() {
  Volume<float> volume(test::grid({kSide, kSide, kSide}));
  const std::vector<std::int32_t> numbers = ball();
  for (std::size_t v = 0; v < numbers.size(); ++v)
    volume.data[v] = numbers[v] < 0 ? 0 : float(numbers[v]) / 255;
  return volume;
}

void expectBall(const fs::path& path) {
  const Scan scan = readScan(path);
  const Volume<float> wanted = expected();
  ASSERT_EQ(scan.volume->geometry.dims, wanted.geometry.dims);
  for (std::size_t v = 0; v < wanted.data.size(); ++v)
    ASSERT_NEAR(scan.volume->data[v], wanted.data[v], 1e-5) << "voxel " << v;
}

const auto asIs = [](int number, int) { return number; };

TEST(DicomNumbers, PaddingIsOutsideWhateverItsValueAndType) {
  struct Case {
    const char* name;
    int allocated, stored;
    bool isSigned;
    int padding;
  };
  for (const Case& c : {Case{"8 bit", 8, 8, false, 255},
                        {"8 bit, within the range", 8, 8, false, 77},
                        {"unsigned", 16, 16, false, 63536},
                        {"signed", 16, 16, true, -2000},
                        {"12 bits", 16, 12, false, 4095},
                        {"12 bits, signed", 16, 12, true, -2000}}) {
    SCOPED_TRACE(c.name);
    const TempFolder folder;
    // A value that was recorded too is padding all the same: then voxels of it are missing.
    const auto number = [&](int n, int) { return n < 0 ? c.padding : n == c.padding ? n + 1 : n; };
    series(folder, number, [&](DicomImage& image, int) {
      image.allocated = c.allocated, image.stored = c.stored, image.isSigned = c.isSigned;
      image.padding = c.padding;
    });
    const Scan scan = readScan(folder.path());
    const std::vector<std::int32_t> numbers = ball();
    for (std::size_t v = 0; v < numbers.size(); ++v)
      ASSERT_NEAR(scan.volume->data[v], numbers[v] < 0 ? 0 : float(number(numbers[v], 0)) / 255, 1e-5) << v;
    EXPECT_LE(readVolumeInfo(folder.path()).valueMax, 200);
    EXPECT_GE(readVolumeInfo(folder.path()).valueMin, 20);
  }
}

// Whatever the file says of the type of the padding's elements, and where it says nothing.
TEST(DicomNumbers, PaddingIsReadInEveryTransferSyntax) {
  for (const bool explicitTypes : {true, false})
    for (const bool paddingIsSigned : {true, false}) {
      SCOPED_TRACE(fmt::format("{} {}", explicitTypes, paddingIsSigned));
      const TempFolder folder;
      int next = 0;
      const auto number = [&](int n, int) { return n < 0 ? -1000 - next++ % 25 : n; };
      series(folder, number, [&](DicomImage& image, int) {
        image.isSigned = true, image.padding = -1000, image.paddingLimit = -1024;
        image.explicitTypes = explicitTypes, image.paddingIsSigned = paddingIsSigned;
      });
      EXPECT_GE(readVolumeInfo(folder.path()).valueMin, 20);
      expectBall(folder.path());
    }
}

// Padding that lies inside, away from the sides, only the tag can tell.
TEST(DicomNumbers, PaddingWithinTheScanIsObeyed) {
  const TempFolder folder;
  const auto number = [](int n, int) { return n < 0 ? 30 : n > 190 ? -500 : n; };
  series(folder, number, [](DicomImage& image, int) { image.isSigned = true, image.padding = -500; });
  const Scan scan = readScan(folder.path());
  const std::vector<std::int32_t> numbers = ball();
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (numbers[v] > 190) {
      ASSERT_EQ(scan.volume->data[v], 0) << v;
    }
  EXPECT_GE(readVolumeInfo(folder.path()).valueMin, 20);
}

// From value to limit, in either order.
TEST(DicomNumbers, PaddingMayBeARange) {
  for (const bool turned : {false, true}) {
    const TempFolder folder;
    int next = 0;
    const auto number = [&](int n, int) { return n < 0 ? -1000 - next++ % 25 : n; };
    series(folder, number, [&](DicomImage& image, int) {
      image.isSigned = true;
      image.padding = turned ? -1024 : -1000, image.paddingLimit = turned ? -1000 : -1024;
    });
    expectBall(folder.path());
  }
}

// The tag is in the numbers as they are stored: slope and intercept apply to it as to the pixels.
TEST(DicomNumbers, ScaleAndPaddingGoTogether) {
  struct Scale {
    double slope, intercept;
  };
  for (const Scale& s : {Scale{1, -1024}, {0.1, 0}, {2, -40}, {1.0 / 3, 5}, {1e-3, -0.5}, {-1, 255}}) {
    SCOPED_TRACE(fmt::format("{} {}", s.slope, s.intercept));
    const TempFolder folder, plain;
    const auto number = [](int n, int) { return n < 0 ? -2000 : 10 * n; };
    series(folder, number, [&](DicomImage& image, int) {
      image.isSigned = true, image.padding = -2000;
      image.slope = s.slope, image.intercept = s.intercept;
    });
    const VolumeInfo info = readVolumeInfo(folder.path());
    const double a = s.slope * 200 + s.intercept, b = s.slope * 1990 + s.intercept;
    EXPECT_NEAR(info.valueMin, std::min(a, b), 25 * std::abs(s.slope));
    EXPECT_NEAR(info.valueMax, std::max(a, b), 25 * std::abs(s.slope));
    const Scan scan = readScan(folder.path());
    const std::vector<std::int32_t> numbers = ball();
    const auto at = [&](int n) {
      return float((s.slope * 10 * n + s.intercept - scan.originalMin) /
                   (scan.originalMax - scan.originalMin));
    };
    for (std::size_t v = 0; v < numbers.size(); ++v)
      ASSERT_NEAR(scan.volume->data[v], numbers[v] < 0 ? 0 : std::clamp(at(numbers[v]), 0.f, 1.f), 1e-4);
  }
}

// Slices of a PET have a scale each; what they hold together is what they mean.
TEST(DicomNumbers, EverySliceHasItsOwnScale) {
  const TempFolder folder;
  const auto slope = [](int k) { return 0.5 + 0.25 * (k % 3); };
  const auto number = [&](int n, int k) { return n < 0 ? -7 : int(std::lround(50 * n / slope(k))); };
  series(folder, number, [&](DicomImage& image, int k) {
    image.isSigned = true, image.padding = -7;
    image.slope = slope(k), image.intercept = 0.25;
  });
  const Scan scan = readScan(folder.path());
  const std::vector<std::int32_t> numbers = ball();
  const double width = scan.originalMax - scan.originalMin;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const double meant = (50 * numbers[v] + 0.25 - scan.originalMin) / width;
    ASSERT_NEAR(scan.volume->data[v], numbers[v] < 0 ? 0 : std::clamp(meant, 0.0, 1.0), 1e-3) << v;
  }
}

TEST(DicomNumbers, SlicesOfDifferentTypesAreRefusedForThat) {
  const TempFolder folder;
  series(folder, asIs, [](DicomImage& image, int k) {
    image.isSigned = true;
    if (k > 7) image.slope = 0.5, image.intercept = 0;
  });
  expectError([&] { readScan(folder.path()); }, "numbers of different types");
}

// Bits above the stored ones are no part of the number, and the highest stored one is the sign.
TEST(DicomNumbers, SignsNeedNotBeExtended) {
  const TempFolder folder;
  const auto number = [](int n, int) { return (n < 0 ? -2000 : n - 100) & 0x0fff; };
  series(folder, number,
         [](DicomImage& image, int) { image.stored = 12, image.isSigned = true, image.padding = -2000; });
  const VolumeInfo info = readVolumeInfo(folder.path());
  EXPECT_NEAR(info.valueMin, -80, 3);
  EXPECT_NEAR(info.valueMax, 99, 3);
}

// White is 0 there; it is read as it is shown, like all others, and so is its padding, wherever that lies.
TEST(DicomNumbers, Monochrome1IsTurnedAndItsPaddingWithIt) {
  for (const int stored : {8, 12, 16}) {
    SCOPED_TRACE(stored);
    const TempFolder folder;
    const int white = (1 << stored) - 1;
    const auto number = [&](int n, int) { return n < 0 ? white : n > 150 ? 7 : white - n; };
    series(folder, number, [&](DicomImage& image, int) {
      image.allocated = stored == 8 ? 8 : 16, image.stored = stored;
      image.photometric = "MONOCHROME1", image.padding = 7;
    });
    const VolumeInfo info = readVolumeInfo(folder.path());
    EXPECT_EQ(info.valueMin, 0);
    EXPECT_NEAR(info.valueMax, 150, 3);
  }
}

TEST(DicomNumbers, FramesOfOneFileHaveThemToo) {
  const TempFolder folder;
  DicomImage image;
  image.columns = image.rows = image.frames = kSide;
  image.isSigned = true, image.padding = -2000;
  image.mediaStorage = "1.2.840.10008.5.1.4.1.1.3.1", image.modality = "US";  // ultrasound of several frames
  for (const std::int32_t n : ball()) image.numbers.push_back(n < 0 ? -2000 : n);
  const fs::path path = folder.write("a.dcm", dicomFile(image));
  expectBall(path);
  EXPECT_EQ(readScan(path).modality, "US");
}

// The same scan in any type is the same, and as another format has it.
TEST(DicomNumbers, TheSameVoxelsAreTheSameScan) {
  const auto plain = [](int allocated, bool isSigned, double slope) {
    return [=](DicomImage& image, int) {
      image.allocated = image.stored = allocated, image.isSigned = isSigned;
      if (slope != 1) image.slope = slope, image.intercept = 0;
    };
  };
  const auto zero = [](int n, int) { return std::max(n, 0); };
  const auto times257 = [](int n, int) { return 257 * std::max(n, 0); };
  {
    const TempFolder folder;
    series(folder, zero, plain(8, false, 1)), expectBall(folder.path());
  }
  {
    const TempFolder folder;
    series(folder, zero, plain(16, false, 1)), expectBall(folder.path());
  }
  {
    const TempFolder folder;
    series(folder, zero, plain(16, true, 1)), expectBall(folder.path());
  }
  {
    const TempFolder folder;
    series(folder, times257, plain(16, false, 1)), expectBall(folder.path());
  }
  {
    const TempFolder folder;
    series(folder, zero, plain(16, false, 1 / 255.0)), expectBall(folder.path());
  }
}

// What the file says of its padding crosses the process that reads it.
TEST(DicomNumbers, PaddingCrossesTheProcess) {
  startReaders();
  const TempFolder folder;
  const auto number = [](int n, int) { return n < 0 ? -2000 : n; };
  series(folder, number, [](DicomImage& image, int) { image.isSigned = true, image.padding = -2000; });
  const LoadedVolume here = loadVolume(folder.path());
  const LoadedVolume apart =
      volumeFrom(readApart({ReaderTask::volume}, folder.path()).bytes(), folder.path());
  ASSERT_EQ(here.stored.padding.size(), std::size_t(kSide));
  ASSERT_EQ(apart.stored.padding.size(), here.stored.padding.size());
  EXPECT_EQ(apart.stored.padding[3].least, -2000);
  EXPECT_EQ(apart.stored.padding[3].most, -2000);
  expectBall(folder.path());
}

// Slices without the tag beside others with it.
TEST(DicomNumbers, SlicesMayLackTheTag) {
  const TempFolder folder;
  const auto number = [](int n, int) { return n < 0 ? -2000 : n; };
  series(folder, number, [](DicomImage& image, int k) {
    image.isSigned = true;
    if (k > 2) image.padding = -2000;
  });
  const LoadedVolume loaded = loadVolume(folder.path());
  ASSERT_EQ(loaded.stored.padding.size(), std::size_t(kSide));
  EXPECT_FALSE(loaded.stored.padding[0].holds(-2000));
  EXPECT_TRUE(loaded.stored.padding[5].holds(-2000));
}

}  // namespace
}  // namespace sonoskin
