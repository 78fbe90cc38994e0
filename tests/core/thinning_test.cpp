#include "core/surface/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A Lorentzian shell across a sphere, as the classification makes of a sharp edge, and the edge itself.
struct Shell {
  Geometry geometry;
  glm::dvec3 centre;
  double radius;
  Volume<float> u, v;

  Shell(glm::ivec3 dims, glm::dvec3 spacing, double r)
      : geometry(test::grid(dims, spacing)), centre(0.5 * glm::dvec3(dims - 1) * spacing + 0.013), radius(r) {
    u = test::fill(geometry, [&](glm::dvec3 p) {
      const double d = (glm::length(p - centre) - radius) / geometry.minSpacing();
      return 1 / (1 + d * d / 4);
    });
    v = test::fill(geometry, [&](glm::dvec3 p) {
      return 0.5 * (1 - std::tanh((glm::length(p - centre) - radius) / (3 * geometry.minSpacing())));
    });
  }
  double offset(const SurfaceVoxel& s) const {
    return glm::length(geometry.toWorld(glm::dvec3(s.position)) - centre) - radius;
  }
};

SurfaceOptions everywhere() {
  SurfaceOptions o;
  o.facing = -1;
  o.borderMargin = 0;
  o.threshold = 0.5;
  return o;
}

TEST(Thinning, FindsTheSphereToATenthOfAVoxel) {
  const Shell shell({48, 48, 48}, glm::dvec3(1), 15);
  const auto found = thin(shell.u, shell.v, {}, everywhere());
  ASSERT_GT(found.size(), 2000u);
  for (const auto& s : found) EXPECT_NEAR(shell.offset(s), 0, 0.1) << glm::length(glm::vec3(s.voxel));
}

// On long voxels too, a tenth of a voxel along each axis. A sphere must not bend much within a voxel: its radius is 15
// of the longest.
TEST(Thinning, FindsItOnLongVoxelsToo) {
  for (const glm::dvec3 spacing : {glm::dvec3(0.3, 0.3, 0.9), glm::dvec3(1, 0.6, 0.8), glm::dvec3(1, 1, 2)}) {
    const double radius = 15 * std::max({spacing.x, spacing.y, spacing.z});
    const Shell shell(glm::ivec3(2.5 * radius / spacing) + 4, spacing, radius);
    const auto found = thin(shell.u, shell.v, {}, everywhere());
    ASSERT_GT(found.size(), 1000u);
    for (const auto& s : found) {
      const glm::dvec3 fromCentre = shell.geometry.toWorld(glm::dvec3(s.position)) - shell.centre;
      const double voxels = std::abs(shell.offset(s)) * glm::length(glm::normalize(fromCentre) / spacing);
      EXPECT_LT(voxels, 0.1) << spacing.z;
    }
  }
}

// One sheet without gaps: every ray from the centre meets a surface voxel within a voxel of where it should.
TEST(Thinning, LeavesNoGapInTheSheet) {
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(0.5, 0.5, 1.5)}) {
    const Shell shell(glm::ivec3(48.0 * spacing.x / spacing), spacing, 15 * spacing.x);
    const auto found = thin(shell.u, shell.v, {}, everywhere());
    Volume<std::uint8_t> mark(shell.geometry);
    for (const auto& s : found) mark.at(s.voxel.x, s.voxel.y, s.voxel.z) = 1;
    for (int n = 0; n < 2000; ++n) {
      const double z = 2 * test::noise(std::uint64_t(n)) - 1,
                   phi = 6.2831853 * test::noise(std::uint64_t(n) + 5000);
      const glm::dvec3 direction(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi),
                                 z);
      const glm::ivec3 at(glm::round((shell.centre + shell.radius * direction) / spacing));
      bool hit = false;
      for (int corner = 0; corner < 27; ++corner)
        hit |= mark.at(at.x + corner % 3 - 1, at.y + corner / 3 % 3 - 1, at.z + corner / 9 - 1) != 0;
      EXPECT_TRUE(hit);
    }
  }
}

// Where u does not fall off for some voxels, the one toward the dark is the surface, and no other.
TEST(Thinning, APlateauGivesOneSheet) {
  for (const int width : {1, 2, 3, 5}) {
    const Geometry g = test::grid({12, 24, 12});
    const auto v = test::fill(g, [](glm::dvec3 p) { return std::min(1.0, p.y / 24); });
    const auto u = test::fill(g, [&](glm::dvec3 p) {
      const double beyond = p.y < 10 ? 10 - p.y : p.y > 9 + width ? p.y - (9 + width) : 0;
      return 1 / (1 + beyond * beyond);
    });
    auto options = everywhere();
    options.threshold = 1;  // as strong as is asked for
    const auto found = thin(u, v, {}, options);
    EXPECT_EQ(found.size(), 100u) << width;
    for (const auto& s : found) EXPECT_EQ(s.voxel.y, 10) << width;
  }
}

TEST(Thinning, DoesNotDependOnTheNumberOfThreads) {
  const Shell shell({48, 48, 48}, glm::dvec3(1), 15);
  setThreadCount(1);
  const auto one = thin(shell.u, shell.v, {}, everywhere());
  setThreadCount(3);
  const auto three = thin(shell.u, shell.v, {}, everywhere());
  setThreadCount(0);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t n = 0; n < one.size(); ++n) {
    EXPECT_EQ(one[n].voxel, three[n].voxel);
    EXPECT_EQ(one[n].position, three[n].position);
  }
}

TEST(Thinning, FacingKeepsTheSideTowardTheProbe) {
  const Shell shell({48, 48, 48}, glm::dvec3(1), 15);
  auto options = everywhere();
  options.facing = 0.1;
  options.sides = 0;
  ScanFrame frame;
  frame.beam.axis = {0, 1, 0};
  const auto found = thin(shell.u, shell.v, frame, options);
  ASSERT_GT(found.size(), 800u);
  for (const auto& s : found) EXPECT_LT(double(s.position.y), shell.centre.y);
  // For growSides() what does not face the probe is there too, and says so; the far end of the shell is not.
  options.sides = 3;
  const auto withSides = thin(shell.u, shell.v, frame, options);
  EXPECT_EQ(std::ranges::count_if(withSides, [](const SurfaceVoxel& s) { return s.facing > 0.1f; }),
            std::ptrdiff_t(found.size()));
  EXPECT_GT(withSides.size(), found.size() + 400);
  for (const auto& s : withSides) EXPECT_LT(double(s.position.y), shell.centre.y + 0.8 * 15);
}

// What lies on the volume's own sides has no neighbours to be compared with.
TEST(Thinning, TheOutermostVoxelsAreNoSurface) {
  const Geometry g = test::grid({20, 20, 20});
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {0.0, 19.0}) {
      const auto v = test::fill(g, [&](glm::dvec3 p) { return p[axis] / 20; });
      const auto u = test::fill(g, [&](glm::dvec3 p) { return 1 / (1 + 4 * std::pow(p[axis] - side, 2)); });
      auto options = everywhere();
      options.threshold = 0.01;
      EXPECT_TRUE(thin(u, v, {}, options).empty()) << axis << " " << side;
    }
}

TEST(Thinning, NothingIsFoundNearTheSidesOfTheView) {
  for (const double spacing : {1.0, 2.0}) {
    const Shell shell({48, 48, 48}, glm::dvec3(spacing), 15 * spacing);
    auto options = everywhere();
    options.borderMargin = 3;  // voxels
    ScanFrame frame;
    frame.view.sides = {glm::vec4(1, 0, 0, -30 * spacing)};  // the view ends at x = 30 voxels
    const auto all = thin(shell.u, shell.v, {}, options), within = thin(shell.u, shell.v, frame, options);
    EXPECT_LT(within.size(), all.size());
    EXPECT_EQ(within.size(),
              std::size_t(std::ranges::count_if(all, [](const auto& s) { return s.voxel.x <= 27; })));
    for (const auto& s : within) EXPECT_LE(s.voxel.x, 27);
  }
}

TEST(Thinning, StopsWhenCancelled) {
  const Shell shell({16, 16, 16}, glm::dvec3(1), 5);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(thin(shell.u, shell.v, {}, everywhere(), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
