#include "core/classification/chebyshev.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/classification/data_term.h"
#include "core/classification/pcg.h"
#include "tests/support/applied.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A ball in a volume of several tiles, with flat voxels as scans of faces have them.
struct System {
  Geometry geometry = test::grid({200, 40, 30}, {0.3, 0.3, 0.9});
  Volume<float> volume = test::speckledSphere(geometry, {20, 6, 13}, 4, 0.3);
  Smoothed smoothed{volume, {}};
  ClassificationOptions options;
  ScaledSystem scaled;
  LargeArray<float> start = LargeArray<float>(geometry.voxels());

  explicit System(double tangentialLength = 3) {
    options.isoValue = 0.35;
    options.tangentialLength = tangentialLength;
    scaleSystem({volume, volume, options}, k(), nullptr, scaled, start.data());
  }
  NeighbourTerms k() const { return neighbourTerms(smoothed, options); }
  LargeArray<float> solve(double tolerance, FastSolution* solution = nullptr) const {
    LargeArray<float> u = start, scratch(u.size());
    const FastSolution found = solveFast(k(), scaled, tolerance, u, scratch);
    if (solution) *solution = found;
    return u;
  }
  LargeArray<float> exact() const { return solvePcg(k(), dataTerm({volume, volume, options}), 1e-7).u; }
  // |b - A u| / |b| in single precision, straight from the definition.
  double residual(const LargeArray<float>& u) const {
    const DataTerm term = dataTerm({volume, volume, options});
    const auto ku = test::applied(k(), u);
    double rr = 0, bb = 0;
    for (std::size_t v = 0; v < ku.size(); ++v) {
      const double b = double(term.right[v]);
      rr += std::pow(b - double(term.diagonal[v]) * double(u[v]) - double(ku[v]), 2);
      bb += b * b;
    }
    return std::sqrt(rr / bb);
  }
};

TEST(Chebyshev, StartsFromTheSolutionWithoutK) {
  const System s;
  const DataTerm term = dataTerm({s.volume, s.volume, s.options});
  for (std::size_t v = 0; v < s.start.size(); ++v)
    ASSERT_NEAR(s.start[v], term.right[v] / term.diagonal[v], 1e-6);
}

TEST(Chebyshev, ReachesTheToleranceItReports) {
  for (const double length : {1.0, 3.0, 6.0}) {
    const System s(length);
    for (const double tolerance : {1e-2, 2e-3, 1e-3}) {
      FastSolution solution;
      const auto u = s.solve(tolerance, &solution);
      EXPECT_TRUE(solution.converged);
      EXPECT_LE(s.residual(u), tolerance) << "length " << length;
      EXPECT_LE(solution.sweeps, 40);
    }
  }
}

TEST(Chebyshev, InteractiveToleranceIsWithinTwoHundredthsOfTheSolution) {
  for (const double length : {1.0, 3.0, 6.0}) {
    const System s(length);
    const auto u = s.solve(2e-3), exact = s.exact();
    double squares = 0;
    for (std::size_t v = 0; v < u.size(); ++v) {
      ASSERT_NEAR(u[v], exact[v], 0.02) << "length " << length;
      squares += std::pow(double(u[v] - exact[v]), 2);
    }
    EXPECT_LT(std::sqrt(squares / double(u.size())), 4e-4);
  }
}

// More than half of the volume lies outside the sector.
TEST(Chebyshev, LeavesOutWhatDoesNotMove) {
  System s;
  for (int k = 0; k < s.geometry.dims.z; ++k)
    for (int j = 15; j < s.geometry.dims.y; ++j) std::fill_n(&s.volume.at(0, j, k), s.geometry.dims.x, 0.0f);
  s.smoothed.lowPassed = s.volume;
  scaleSystem({s.volume, s.volume, s.options}, s.k(), nullptr, s.scaled, s.start.data());
  FastSolution solution;
  s.solve(1e-3, &solution);
  EXPECT_LT(double(solution.updates), 0.75 * solution.sweeps * double(s.geometry.voxels()));
}

// A new iso-value moves the shell: the moved answer is nearer to the new one than b/c.
TEST(Chebyshev, WarmStartIsNearer) {
  System s;
  LargeArray<float> before = s.exact(), cold = s.start;
  s.options.isoValue += 0.01;
  LargeArray<float> warm(before.size());
  scaleSystem({s.volume, s.volume, s.options}, s.k(), before.data(), s.scaled, warm.data());
  scaleSystem({s.volume, s.volume, s.options}, s.k(), nullptr, s.scaled, cold.data());
  EXPECT_LT(s.residual(warm), 0.4 * s.residual(cold));
}

// With the bound on the eigenvalues much too low the steps are too long: it must say so instead of giving nonsense.
TEST(Chebyshev, SaysWhenItDiverges) {
  System s(8);
  for (Half& own : s.scaled.own) own = toHalf(3 * toFloat(own));  // c no longer fits to the diagonal
  s.scaled.leastOwn = 0.9;
  FastSolution solution;
  s.solve(1e-4, &solution);
  EXPECT_FALSE(solution.converged);
}

TEST(Chebyshev, SameBitsOnAnyNumberOfThreads) {
  const System s;
  setThreadCount(1);
  const auto one = s.solve(1e-3);
  setThreadCount(3);
  const auto three = s.solve(1e-3);
  setThreadCount(0);
  EXPECT_EQ(one, three);
}

TEST(Chebyshev, StopsWhenCancelledAndRisesToOne) {
  const System s;
  ProgressSink sink;
  double last = 0;
  sink.report = [&](double fraction) { last = fraction; };
  LargeArray<float> u = s.start, scratch(u.size());
  solveFast(s.k(), s.scaled, 2e-3, u, scratch, Progress(sink));
  EXPECT_GT(last, 0.9);
  sink.cancel = true;
  EXPECT_THROW(solveFast(s.k(), s.scaled, 2e-3, u, scratch, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
