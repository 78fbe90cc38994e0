#include "core/classification/slab_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/classification/neighbour_terms.h"
#include "core/classification/pcg.h"
#include "core/classification/smoothed.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

ClassificationOptions optionsForTests(double tolerance) {
  ClassificationOptions o;
  o.isoValue = 0.35;
  o.tolerance = tolerance;
  return o;
}

// Skin, part of a large ball, that runs through all slabs, and the same system in one piece.
struct LongVolume {
  Volume<float> volume =
      test::speckledSphere(test::grid({40, 40, 130}, {0.3, 0.3, 0.9}), {-194, 6, 58}, 200, 0.4);
  ClassificationOptions options = optionsForTests(1e-6);
  Smoothed smoothed = smooth(volume, options);
  DataSource source{volume, smoothed.lowPassed, options, {}};

  LargeArray<float> inOnePiece() const {
    return solvePcg(neighbourTerms(smoothed, options), dataTerm(source), options.tolerance).u;
  }
};

TEST(SlabSolver, EqualsTheSolutionInOnePiece) {
  const LongVolume v;
  ASSERT_LT(planSlabs(v.volume.geometry, v.options).slices, v.volume.geometry.dims.z / 2);
  const Volume<float> u = solveInSlabs(v.source);
  const LargeArray<float> expected = v.inOnePiece();
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(u.data[i], expected[i], 5e-4) << i;
}

// With a tenth of the slices beyond, the same volume is wrong by more than that: the bound above can fail.
TEST(SlabSolver, NeedsTheSlicesBeyond) {
  const LongVolume v;
  const SlabPlan plan = planSlabs(v.volume.geometry, v.options);
  const int last = plan.slices;
  const Geometry& g = v.volume.geometry;
  auto directions = std::make_shared<Directions>();
  setDirections(v.smoothed.lowPassed, v.options.directionScale, {0, last}, *directions);
  DataTerm term = dataTerm(v.source);
  term.diagonal.resize(g.index(0, 0, last));
  term.right.resize(g.index(0, 0, last));
  const Solution cut = solvePcg(neighbourTerms(directions, v.options), std::move(term), v.options.tolerance);
  const LargeArray<float> expected = v.inOnePiece();
  float worst = 0;
  for (std::size_t i = 0; i < cut.u.size(); ++i) worst = std::max(worst, std::abs(cut.u[i] - expected[i]));
  EXPECT_GT(worst, 5e-3f);
}

// Known slices stay as they are, and the others are the solution beside them.
TEST(SlabSolver, SolvesBesideKnownSlices) {
  const LongVolume v;
  const LargeArray<float> expected = v.inOnePiece();
  const Geometry& g = v.volume.geometry;
  const int first = 50;
  const std::size_t from = g.index(0, 0, first), count = g.voxels() - from;
  auto directions = std::make_shared<Directions>();
  setDirections(v.smoothed.lowPassed, v.options.directionScale, {first, g.dims.z}, *directions);
  const DataTerm term = dataTerm(v.source);
  LargeArray<float> u(term.right.begin() + std::ptrdiff_t(from), term.right.end());
  std::copy_n(expected.begin() + std::ptrdiff_t(from), g.index(0, 0, 1), u.begin());
  PcgSystem system;
  system.u = u.data();
  system.known = 1;
  system.diagonal.assign(term.diagonal.begin() + std::ptrdiff_t(from), term.diagonal.end());
  solvePcg(neighbourTerms(directions, v.options), system, v.options.tolerance);
  for (std::size_t i = 0; i < g.index(0, 0, 1); ++i) ASSERT_EQ(u[i], expected[from + i]);
  for (std::size_t i = 0; i < count; ++i) ASSERT_NEAR(u[i], expected[from + i], 1e-5) << i;
}

// Slabs of a volume whose voxels are as long as wide are thicker; one that is hardly longer than that is one piece.
TEST(SlabSolver, PlansByMillimetres) {
  const ClassificationOptions o;
  const SlabPlan flat = planSlabs(test::grid({8, 8, 500}, {0.3, 0.3, 0.9}), o);
  const SlabPlan cubes = planSlabs(test::grid({8, 8, 500}, {0.3, 0.3, 0.3}), o);
  EXPECT_NEAR(cubes.beyond, 3 * flat.beyond, 3);
  EXPECT_LE(cubes.slices, 6 * cubes.beyond);
  EXPECT_EQ(planSlabs(test::grid({8, 8, 60}, {0.3, 0.3, 0.3}), o).slices, 60);
  EXPECT_EQ(planSlabs(test::grid({8, 8, 60}, {0.3, 0.3, 0.3}), o).beyond, 0);
}

// It is the square root of beta, which is as the length squared, over what holds a voxel.
TEST(SlabSolver, CouplingLengthGrowsWithTheTangentialLength) {
  ClassificationOptions o;
  const double length = couplingLength(o);
  EXPECT_GT(length, 2);
  EXPECT_LT(length, 3);
  o.tangentialLength *= 2;
  EXPECT_NEAR(couplingLength(o), 2 * length, 1e-9);
}

}  // namespace
}  // namespace sonoskin
