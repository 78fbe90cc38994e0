#include "core/volume/mirror_scan.h"

#include <gtest/gtest.h>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

Scan slantedScan() {
  Geometry g = test::grid({5, 7, 9}, {0.5, 1, 2});
  g.origin = {3, -4, 5};
  const double c = std::cos(0.3), s = std::sin(0.3);
  g.direction = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1);
  Scan scan;
  scan.volume = std::make_shared<Volume<float>>(g, 0.5f);
  scan.mask = std::make_shared<Volume<std::uint8_t>>(g, std::uint8_t(1));
  scan.beam = Beam{glm::dvec3(1, 2, 3), {0, 1, 0}, {1, 0, 0}};
  scan.key = scanKey(*scan.volume, scan.beam);
  return scan;
}

TEST(MirrorScan, TurnsOneAxisOverAboutTheMiddle) {
  const Scan before = slantedScan();
  const Geometry& g = before.volume->geometry;
  for (const MirroredAxis axis : {MirroredAxis::i, MirroredAxis::j, MirroredAxis::k}) {
    Scan scan = before;
    mirrorScan(scan, axis);
    const Geometry& m = scan.volume->geometry;
    EXPECT_TRUE(m.mirrors());
    EXPECT_EQ(scan.mask->geometry.direction, m.direction);
    EXPECT_NE(scan.key, before.key);
    const int a = int(axis) - 1;
    glm::dvec3 index(1, 2, 3), other = index;
    other[a] = g.dims[a] - 1 - index[a];
    EXPECT_LT(glm::distance(m.toWorld(index), g.toWorld(other)), 1e-12);
    // The apex keeps its place among the voxels.
    EXPECT_LT(glm::distance(m.toIndex(*scan.beam->apex), g.toIndex(*before.beam->apex)), 1e-12);
    EXPECT_LT(glm::distance(glm::transpose(m.direction) * scan.beam->axis,
                            glm::transpose(g.direction) * before.beam->axis),
              1e-12);
    mirrorScan(scan, axis);
    EXPECT_FALSE(scan.volume->geometry.mirrors());
    EXPECT_LT(glm::distance(scan.volume->geometry.origin, g.origin), 1e-12);
  }
}

TEST(MirrorScan, LeavesAScanAloneWhereNoneIsNamed) {
  Scan scan = slantedScan();
  const Key key = scan.key;
  mirrorScan(scan, MirroredAxis::none);
  EXPECT_EQ(scan.key, key);
}

}  // namespace
}  // namespace sonoskin
