#include "core/io/scanners/kretz_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/log.h"
#include "tests/support/expect_error.h"
#include "tests/support/kretz.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::KretzWriter;
using test::ramp;

constexpr double kRight = glm::half_pi<double>();
const std::vector<double> kFan{kRight - 0.3, kRight, kRight + 0.3}, kSweep{kRight - 0.2, kRight + 0.2};
const std::string kVoxels = ramp(24);

KretzWriter toroidal() {
  return KretzWriter().whole(1, 0x100, 0x10, 4).dims(4, 3, 2).torus(kFan, kSweep).record(0xD000, 1, kVoxels);
}
KretzWriter cartesian() {
  return KretzWriter().whole(1, 0x100, 1, 4).dims(4, 3, 2).values(0x10, 0x22, {0.25});
}

LoadedVolume read(const KretzWriter& file, const ReadOptions& options = {}) {
  return kretzVolume(file.span(), options, "a.vol");
}
std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }
bool warns(const LogRecord& record, const std::string& part) {
  for (const std::string& sentence : record.sentences(LogLevel::warning))
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

TEST(KretzFile, GivesSamplesAndTheirGrid) {
  const LoadedVolume loaded = read(toroidal().end());
  EXPECT_EQ(text(loaded.numbers), kVoxels);
  EXPECT_EQ(loaded.stored.geometry.dims, glm::ivec3(4, 3, 2));
  EXPECT_EQ(loaded.stored.type, NumberType::uint8);
  ASSERT_TRUE(loaded.stored.grid);
  const auto& grid = std::get<SweptGrid>(*loaded.stored.grid);
  EXPECT_FALSE(gridFault(grid));
  EXPECT_DOUBLE_EQ(grid.sampleDistance, 0.5);
  EXPECT_DOUBLE_EQ(grid.firstRadius, 20);
  EXPECT_DOUBLE_EQ(grid.axisDepth, 8);
  ASSERT_EQ(grid.fan.size(), 3u);
  EXPECT_NEAR(grid.fan[2], 0.3, 1e-15);
  EXPECT_NEAR(grid.sweep[0], -0.2, 1e-15);
}

TEST(KretzFile, NeedsNeitherOrderNorEndAndBearsWhatFollows) {
  const KretzWriter before = KretzWriter().record(0xD000, 1, kVoxels).record(0, 1, "xy").torus(kFan, kSweep);
  EXPECT_EQ(text(read(KretzWriter(before).dims(4, 3, 2)).numbers), kVoxels);
  KretzWriter padded =
      KretzWriter(before).dims(4, 3, 2).end().record(0xD100, 1, "after the end nothing counts");
  EXPECT_EQ(text(read(padded).numbers), kVoxels);
  const std::string pad = KretzWriter(before).dims(4, 3, 2).bytes() + std::string(3, '\0');
  const KretzWriter odd(pad);
  EXPECT_EQ(text(read(odd).numbers), kVoxels);
}

TEST(KretzFile, TakesTheSpacingOfVoxelsFromEitherRecord) {
  LogRecord record;
  const LoadedVolume first = read(cartesian().record(0xD000, 1, kVoxels));
  EXPECT_FALSE(first.stored.grid);
  EXPECT_TRUE(first.stored.spacingKnown);
  EXPECT_EQ(first.stored.geometry.spacing, glm::dvec3(0.25));
  const KretzWriter metres =
      KretzWriter().dims(4, 3, 2).values(0xC100, 1, {0.0003}).record(0xD000, 1, kVoxels);
  EXPECT_NEAR(read(metres).stored.geometry.spacing.y, 0.3, 1e-12);
  EXPECT_FALSE(read(KretzWriter().dims(4, 3, 2).record(0xD000, 1, kVoxels)).stored.spacingKnown);
  EXPECT_TRUE(record.sentences(LogLevel::warning).empty());
  read(cartesian().values(0xC100, 1, {0.0003}).record(0xD000, 1, kVoxels));
  EXPECT_TRUE(warns(record, "0.25 and 0.3 mm"));
}

TEST(KretzFile, ReadsSixteenBits) {
  const LoadedVolume loaded = read(cartesian().record(0xD000, 1, ramp(48)));
  EXPECT_EQ(loaded.stored.type, NumberType::uint16);
  EXPECT_EQ(loaded.numbers.size(), 48u);
}

TEST(KretzFile, ListsAndGivesSeveralVolumes) {
  const KretzWriter file = toroidal()
                               .dims(2, 2, 2, 2)
                               .record(0xD000, 0x201, ramp(8, 100))
                               .record(0xD000, 0x101, ramp(24, 50))
                               .record(0xD000, 2, "a filtered copy");
  const std::vector<VolumeEntry> entries = kretzVolumes(file.span(), "a.vol");
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[1].dims, glm::ivec3(4, 3, 2));  // the grey one's where it says nothing itself
  EXPECT_EQ(entries[2].dims, glm::ivec3(2, 2, 2));
  EXPECT_EQ(text(read(file).numbers), kVoxels);
  EXPECT_EQ(text(read(file, {2, 1}).numbers), ramp(24, 50));
  expectError([&] { read(file, {4, 1}); }, "no volume 4");
  expectError(
      [&] {
        read(file, {3, 1});
      },
      "the angles of 3 x 2");  // its own dimensions, the grey one's angles
  EXPECT_TRUE(kretzVolumes(toroidal().span(), "a.vol").empty());
}

TEST(KretzFile, GivesEachTimeStep) {
  const KretzWriter file =
      cartesian().record(0xD000, 1, kVoxels).whole(0xD400, 1, 3).record(0xD600, 1, kVoxels + ramp(48, 24));
  EXPECT_EQ(read(file).stored.timeSteps, 3);
  EXPECT_EQ(text(read(file).numbers), kVoxels);
  EXPECT_EQ(text(read(file, {0, 3}).numbers), ramp(24, 48));
  expectError([&] { read(file, {0, 4}); }, "there is no step 4");
  const KretzWriter alone = cartesian().whole(0xD400, 1, 2).record(0xD600, 1, ramp(96));
  EXPECT_EQ(read(alone).stored.type, NumberType::uint16);
  expectError([&] { read(cartesian().record(0xD600, 1, ramp(25))); }, "do not fit together");
  expectError([&] { read(cartesian().whole(0xD400, 1, 3).record(0xD600, 1, ramp(48))); },
              "do not fit together");
  // A count of another form than is known is left alone.
  EXPECT_EQ(read(cartesian().record(0xD000, 1, kVoxels).record(0xD400, 1, ramp(12))).stored.timeSteps, 1);
  LogRecord record;
  read(cartesian().record(0xD000, 1, kVoxels).whole(0xD400, 1, 5));
  EXPECT_TRUE(warns(record, "5 time steps"));
}

TEST(KretzFile, TellsHowPackedOnesAreSaved) {
  for (const auto& [group, element] :
       {std::pair(0x0002u, 0x1000u), std::pair(0x0002u, 0x1100u), std::pair(0x0002u, 0x1200u),
        std::pair(0xD100u, 0x0001u), std::pair(0xD100u, 0x0201u), std::pair(0xD700u, 0x0103u)})
    expectError([&] { read(KretzWriter().dims(4, 3, 2).record(group, element, "x").end()); },
                "wavelet compression None");
  expectError([] { read(KretzWriter().dims(4, 3, 2).end()); }, "wavelet compression None");
}

TEST(KretzFile, RefusesWhatIsCutOffOrNoSuchFile) {
  expectError([] { read(KretzWriter("KRETZFILE 2.0   ")); }, "version");
  expectError([] { read(KretzWriter("NRRD0004")); }, "no GE Kretz file");
  expectError([] { read(KretzWriter("KRETZ")); }, "no GE Kretz file");
  const std::string whole = toroidal().bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const KretzWriter cut(whole.substr(0, size));
    expectError([&] { read(cut); }, "a.vol");
  }
}

TEST(KretzFile, RefusesSizesThatContradictEachOther) {
  expectError([] { read(cartesian().record(0xD000, 1, ramp(23))); }, "24 voxels, but holds 23");
  expectError([] { read(KretzWriter().dims(65535, 65535, 65535).record(0xD000, 1, ramp(23))); }, "23 bytes");
  expectError([] { read(KretzWriter().dims(4, 3, 0).record(0xD000, 1, ramp(24))); }, "along each axis");
  expectError([] { read(cartesian().record(0xD000, 1, kVoxels).dims(5, 3, 2)); }, "C000,0001 twice");
  expectError([] { read(cartesian().record(0xC000, 0x1, std::string(5, 'a'))); }, "");
}

TEST(KretzFile, RefusesBeamsThatCannotBe) {
  const auto withBeams = [](const std::vector<double>& fan, const std::vector<double>& sweep) {
    return read(KretzWriter().dims(4, 3, 2).torus(fan, sweep).record(0xD000, 1, kVoxels));
  };
  expectError([&] { withBeams({1.4, 1.5}, kSweep); }, "the angles of 2 x 2");
  expectError([&] { withBeams({1.4, 1.6, 1.5}, kSweep); }, "do not rise or fall");
  expectError([&] { withBeams({1.4, 1.5, std::nan("")}, kSweep); }, "no numbers");
  expectError([&] { withBeams({20, 90, 160}, kSweep); }, "half a turn");  // degrees
  expectError([] { read(KretzWriter().dims(4, 3, 2).values(0xC300, 1, kSweep).record(0xD000, 1, kVoxels)); },
              "one direction alone");
  const KretzWriter file = KretzWriter().dims(4, 3, 2).values(0xC300, 1, kSweep).values(0xC300, 2, kFan);
  expectError([&] { read(KretzWriter(file).record(0xD000, 1, kVoxels)); }, "how far apart");
  for (const double metres : {0.0, -0.0005, std::nan(""), double(INFINITY)})
    expectError([&] { read(KretzWriter(file).values(0xC100, 1, {metres}).record(0xD000, 1, kVoxels)); },
                "how far apart");
  expectError([&] { read(KretzWriter(file).values(0xC100, 1, {0.0005}).record(0xD000, 1, kVoxels)); },
              "where its beams begin");
}

TEST(KretzFile, SaysWhatItAssumes) {
  LogRecord record;
  read(toroidal());
  EXPECT_TRUE(record.take().empty());
  const auto withFan = [](const std::vector<double>& fan) {
    const LoadedVolume loaded =
        read(KretzWriter().dims(4, 3, 2).torus(fan, kSweep).record(0xD000, 1, kVoxels));
    return std::get<SweptGrid>(*loaded.stored.grid).fan;
  };
  EXPECT_NEAR(withFan({kRight - 0.1, kRight, kRight + 0.3})[0], -0.1, 1e-15);
  EXPECT_TRUE(warns(record, "to one side"));
  EXPECT_NEAR(withFan({-0.3, 0, 0.3})[0], -0.3, 1e-15);
  EXPECT_TRUE(warns(record, "their middle is assumed"));
  read(KretzWriter().whole(1, 0x100, 1, 4).dims(4, 3, 2).torus(kFan, kSweep).record(0xD000, 1, kVoxels));
  EXPECT_TRUE(warns(record, "samples of beams are assumed"));
  read(KretzWriter().whole(1, 0x100, 0x10, 4).dims(4, 3, 2).record(0xD000, 1, kVoxels));
  EXPECT_TRUE(warns(record, "voxels are assumed"));
}

TEST(KretzFile, TakesNoPersonalData) {
  LogRecord record;
  KretzWriter file = toroidal();
  for (const unsigned group : {0x0110u, 0x0120u, 0x0130u, 0x0140u, 0x0150u})
    for (unsigned element = 1; element < 5; ++element) file.record(group, element, "PLANTED^NAME");
  const LoadedVolume loaded = read(file);
  EXPECT_EQ(text(loaded.numbers), kVoxels);
  EXPECT_EQ(loaded.stored.format.find("PLANTED"), std::string::npos);
  EXPECT_TRUE(record.take().empty());
}

}  // namespace
}  // namespace sonoskin
