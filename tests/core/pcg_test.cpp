#include "core/classification/pcg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/applied.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

struct System {
  Geometry geometry = test::grid({20, 20, 20});
  Volume<float> volume = test::speckledSphere(geometry, {9, 10, 11}, 6, 0.4);
  NeighbourTerms k{TangentialOperator(std::make_shared<const Directions>(cellDirections(volume, 0.02)), 6)};
  DataTerm term;
  System() {
    ClassificationOptions o;
    o.isoValue = 0.35;
    term = dataTerm({volume, volume, o});
  }
};

// The residual that the solver reports is that of the answer, computed anew.
TEST(Pcg, ReportsItsTrueResidual) {
  const System s;
  const Solution solution = solvePcg(s.k, s.term, 1e-4);
  const auto ku = test::applied(s.k, solution.u);
  double rr = 0, bb = 0;
  for (std::size_t v = 0; v < ku.size(); ++v) {
    const double r =
        double(s.term.right[v]) - double(s.term.diagonal[v]) * double(solution.u[v]) - double(ku[v]);
    rr += r * r;
    bb += double(s.term.right[v]) * double(s.term.right[v]);
  }
  EXPECT_LE(solution.residual, 1e-4);
  EXPECT_NEAR(std::sqrt(rr / bb), solution.residual, 2e-6);
}

TEST(Pcg, NeedsFewIterations) {
  const System s;
  EXPECT_LE(solvePcg(s.k, s.term, 1e-3).iterations, 20);
  EXPECT_GT(solvePcg(s.k, s.term, 1e-3).iterations, 1);
}

TEST(Pcg, ProgressRisesToOne) {
  const System s;
  ProgressSink sink;
  double last = 0;
  sink.report = [&](double fraction) {
    EXPECT_GE(fraction, last - 0.2);  // conjugate gradients may take a step back now and then
    last = fraction;
  };
  solvePcg(s.k, s.term, 1e-4, Progress(sink));
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace sonoskin
