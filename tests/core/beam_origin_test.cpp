// Where the beams start: found from the sides of sectors that are known.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/volume/field_of_view.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A scanned sector: half openings (rad) across i and across k, with apices `lateral` and `elevation` mm before the
// volume; beams along +j. Swept: the lateral fan turns about the elevation's axis; else the sides are planes.
struct Sector {
  double i, k, lateral, elevation;
  bool swept = false;
};

const glm::ivec3 kDims(64, 48, 56);
const glm::dvec3 kSpacing(0.8, 0.7, 0.9);
const glm::dvec3 kMiddle = 0.5 * glm::dvec3(kDims - 1) * kSpacing;

Volume<float> sectorVolume(const Sector& s) {
  return test::fill(test::grid(kDims, kSpacing), [&](glm::dvec3 p) {
    const double x = p.x - kMiddle.x, z = p.z - kMiddle.z;
    const double radius = s.swept ? std::hypot(p.y + s.elevation, z) - s.elevation : p.y;
    const bool inside = std::abs(x) <= (radius + s.lateral) * std::tan(s.i) &&
                        std::abs(z) <= (p.y + s.elevation) * std::tan(s.k);
    return inside ? 0.4 : 0.0;
  });
}

class BeamOrigin_ : public testing::TestWithParam<Sector> {};

TEST_P(BeamOrigin_, OfASectorIsWhereItsSidesMeet) {
  const Sector s = GetParam();
  const FieldOfView view = findFieldOfView(sectorVolume(s), {});
  ASSERT_TRUE(view.origin.has_value());
  // Two apices: the best point lies between them.
  const double near = std::min(s.lateral, s.elevation), far = std::max(s.lateral, s.elevation);
  EXPECT_NEAR(double(view.origin->x), kMiddle.x, 1.0);
  EXPECT_NEAR(double(view.origin->z), kMiddle.z, 1.0);
  EXPECT_GT(-double(view.origin->y), 0.9 * near - 1);
  EXPECT_LT(-double(view.origin->y), 1.1 * far + 1);
}

INSTANTIATE_TEST_SUITE_P(, BeamOrigin_,
                         testing::Values(Sector{0.35, 0.35, 20, 20}, Sector{0.6, 0.3, 15, 15},
                                         Sector{0.2, 0.2, 60, 60}, Sector{0.7, 0.5, 12, 12, true},
                                         Sector{0.45, 0.3, 30, 18}, Sector{0.5, 0.4, 10, 25, true}));

TEST(BeamOrigin, OfAPhantomWhoseBeamIsThrownAway) {
  PhantomOptions options;
  options.dims = {117, 64, 31};
  const Scan scan = makePhantomScan(options);
  const Beam parallel{std::nullopt, scan.beam->axis, scan.beam->up};
  const FieldOfView view = findFieldOfView(*scan.volume, parallel);
  const Beam found = beamWithin(view, parallel, scan.volume->geometry, {});
  ASSERT_TRUE(found.apex.has_value());
  EXPECT_LT(glm::distance(*found.apex, *scan.beam->apex), 1.2);  // a voxel
  // The cones of its fan are followed, which no hull of planes does: beside the middle of a slice the bound is exact.
  const glm::dvec3 apex = scan.volume->geometry.toIndex(*scan.beam->apex) * scan.volume->geometry.spacing;
  const double side = 62 * std::tan(glm::radians(40.0));
  EXPECT_NEAR(view.depth(glm::vec3(apex + glm::dvec3(side - 5, 62, 0))), 5 * std::cos(glm::radians(40.0)),
              1.2);
}

TEST(BeamOrigin, IsNotFoundWithoutPaddingOrOpening) {
  EXPECT_FALSE(findFieldOfView(Volume<float>(test::grid(kDims, kSpacing), 0.3f), {}).origin);
  const auto block = test::fill(test::grid(kDims, kSpacing), [](glm::dvec3 p) {
    return std::abs(p.x - kMiddle.x) < 15 && std::abs(p.z - kMiddle.z) < 15 ? 0.4 : 0.0;
  });
  EXPECT_FALSE(findFieldOfView(block, {}).origin);
  // A cone that narrows away from the probe is no sector.
  const auto narrowing = test::fill(test::grid(kDims, kSpacing), [](glm::dvec3 p) {
    const double half = 22 - 0.3 * p.y;
    return std::abs(p.x - kMiddle.x) < half && std::abs(p.z - kMiddle.z) < half ? 0.4 : 0.0;
  });
  EXPECT_FALSE(findFieldOfView(narrowing, {}).origin);
}

TEST(BeamOrigin, FollowsTheOptions) {
  const Volume<float> volume = sectorVolume({0.4, 0.4, 20, 20});
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(volume);
  ScanOptions options;
  const FieldOfView view = findFieldOfView(scan, beamOf(scan, options));
  const auto resolved = [&] { return beamWithin(view, beamOf(scan, options), volume.geometry, options); };
  EXPECT_TRUE(resolved().apex.has_value());
  options.beamOrigin = BeamOrigin::parallel;
  EXPECT_FALSE(resolved().apex.has_value());
  options.beamOrigin = BeamOrigin::given;
  options.apex = {1, -2, 3};
  EXPECT_EQ(resolved().apex.value(), glm::dvec3(1, -2, 3));
  // What a file tells is only overruled by name.
  scan.beam = Beam{glm::dvec3(7, -8, 9), {0, 1, 0}, {1, 0, 0}};
  EXPECT_EQ(resolved().apex.value(), glm::dvec3(1, -2, 3));
  options.beamOrigin = BeamOrigin::automatic;
  EXPECT_EQ(resolved().apex.value(), glm::dvec3(7, -8, 9));
  options.beamOrigin = BeamOrigin::parallel;
  EXPECT_FALSE(resolved().apex.has_value());
}

}  // namespace
}  // namespace sonoskin
