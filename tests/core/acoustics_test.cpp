#include "core/phantom/acoustics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace sonoskin {
namespace {

using glm::dvec3;

// Flat anatomies: the skin is a plane through (70, 40, 56).
double nowhere(const dvec3&) { return 50; }
double facing(const dvec3& p) { return 40 - p.y; }
double tilted(const dvec3& p) { return glm::dot(dvec3(70, 40, 56) - p, glm::normalize(dvec3(1.7, 1, 0))); }
double steep(const dvec3& p) { return glm::dot(dvec3(70, 40, 56) - p, glm::normalize(dvec3(6, 1, 0))); }
double slab(const dvec3& p) { return std::max(std::abs(p.y - 48) - 1.5, p.x - 70); }  // bone under one half

DistanceGrid sampled(DistanceFunction f) { return DistanceGrid(sampleDistance(anatomyGrid(1), f, 4)); }

SectorGrid coarseSector() { return phantomSector(dvec3(1.2, 0.3, 3.6)); }

struct Beam2 {
  std::vector<float> amplitudes;
  SectorGrid sector;
  // peak: the strongest echo within 2 mm of range `mm` below the apex, along beam j of the middle elevation.
  float peak(int j, float mm) const {
    float strongest = 0;
    for (int i = 0; i < sector.ranges; ++i) {
      const float range = sector.firstRange + float(i) * sector.rangeStep;
      if (std::abs(range - mm) < 2)
        strongest = std::max(strongest, amplitudes[sector.row(j, sector.elevations / 2) + std::size_t(i)]);
    }
    return strongest;
  }
};

Beam2 insonify(DistanceFunction skin, DistanceFunction bone) {
  const Anatomy anatomy{sampled(skin), sampled(bone), sampled(nowhere)};
  return {echoAmplitude(coarseSector(), anatomy, 1), coarseSector()};
}

TEST(Acoustics, EchoIsStrongestWhereTheSurfaceFacesTheBeam) {
  const int middle = coarseSector().laterals / 2;
  const float a = insonify(facing, nowhere).peak(middle, 85), b = insonify(tilted, nowhere).peak(middle, 85),
              c = insonify(steep, nowhere).peak(middle, 85);
  EXPECT_GT(a, 3 * b);
  EXPECT_GT(b, c);
  EXPECT_LT(a, 0.8f);
}

TEST(Acoustics, BoneCastsAShadow) {
  const Beam2 beam = insonify(facing, slab);
  const int middle = beam.sector.laterals / 2;
  const float shadowed = beam.peak(middle - 8, 103), open = beam.peak(middle + 8, 103);
  EXPECT_LT(shadowed, 0.1f * open);
  EXPECT_GT(open, 0.01f);
}

TEST(Acoustics, SoundFadesWithDepth) {
  const Beam2 beam = insonify(facing, nowhere);
  double shallow = 0, deep = 0;
  for (int j = 20; j < beam.sector.laterals - 20; ++j) shallow += beam.peak(j, 95), deep += beam.peak(j, 113);
  EXPECT_LT(deep, 0.95 * shallow);
}

TEST(Acoustics, TheBabyHidesWhatLiesBehindIt) {
  const SectorGrid sector = coarseSector();
  const DistanceGrid skin = sampled(facing), wall = sampled(nowhere);
  EXPECT_EQ(lossBefore(sector, {skin, wall}, {70, 40, 56}), 0);
  EXPECT_EQ(lossBefore(sector, {skin, wall}, {70, 50, 56}), std::numeric_limits<float>::infinity());
  EXPECT_EQ(lossBefore(sector, {skin, wall}, {70, -10, 56}), std::numeric_limits<float>::infinity());
}

TEST(Acoustics, TheWallTakesItsShare) {
  const SectorGrid sector = coarseSector();
  const DistanceGrid skin = sampled(nowhere);
  const DistanceGrid wall =
      sampled([](const dvec3& p) { return p.y - 20; });  // 20 mm of muscle at 0.06 dB/mm
  EXPECT_NEAR(lossBefore(sector, {skin, wall}, {70.05f, 35, 55.8f}), 1.2, 0.15);
}

TEST(Acoustics, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(sampleAnatomy(PhantomModel(PhantomOptions{}), 1, 0, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
