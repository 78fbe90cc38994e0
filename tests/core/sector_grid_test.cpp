#include "core/phantom/sector_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/phantom/phantom_geometry.h"

namespace sonoskin {
namespace {

PhantomOptions small() {
  PhantomOptions options;
  options.dims = {58, 40, 36};
  return options;
}

TEST(SectorGrid, BeamsAreUnitAndTheMiddleOnePointsAlongY) {
  SectorGrid s = phantomSector(glm::dvec3(0.3, 0.3, 0.9));
  s.laterals = s.elevations = 33;
  EXPECT_NEAR(glm::distance(s.beam(16, 16), glm::vec3(0, 1, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::length(s.beam(3, 30)), 1, 1e-6);
  EXPECT_GT(s.beam(30, 16).x, 0);
  EXPECT_GT(s.beam(16, 30).z, 0);
}

// The values of a function that is linear in range and in both angles come back exactly, wherever the voxel
// lies.
TEST(SectorGrid, ScanConversionReproducesLinearFunctions) {
  const Geometry g = phantomGeometry(small());
  const SectorGrid s = phantomSector(g.spacing);
  std::vector<float> values(s.samples());
  for (int k = 0; k < s.elevations; ++k)
    for (int j = 0; j < s.laterals; ++j)
      for (int i = 0; i < s.ranges; ++i)
        values[s.row(j, k) + std::size_t(i)] = 100 + s.rangeStep * float(i) +
                                               20 * s.lateralStep() * float(j) -
                                               30 * s.elevationStep() * float(k);
  const Volume<float> v = scanConvert(s, values, g);
  int inside = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const glm::vec3 p(g.toWorld({i, j, k})), q = p - s.apex;
        if (s.contains(p, 0.01f)) {
          const float lateral = std::asin(q.x / glm::length(q)), elevation = std::atan2(q.z, q.y);
          const float expected = 100 + glm::length(q) - s.firstRange + 20 * (lateral + s.lateralAngle) -
                                 30 * (elevation + s.elevationAngle);
          ASSERT_NEAR(v.at(i, j, k), expected, 2e-3);
          ++inside;
        } else if (!s.contains(p, -0.01f)) {
          ASSERT_EQ(v.at(i, j, k), 0);
        }
      }
  EXPECT_GT(inside, int(g.voxels() / 2));
  EXPECT_LT(inside, int(g.voxels()));
}

TEST(SectorGrid, StopsWhenCancelled) {
  const Geometry g = phantomGeometry(small());
  const SectorGrid s = phantomSector(g.spacing);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(scanConvert(s, std::vector<float>(s.samples()), g, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
