#include "core/rbf/compact/centres.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/rbf/basis.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

// o_i of every point, by brute force.
std::vector<double> overlaps(const SortedPoints& points, const std::vector<Centre>& centres) {
  std::vector<double> result(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const Centre& c : centres)
      result[i] += double(wendland(glm::distance(points.position(i), c.position) / c.support));
  return result;
}

// The slow original: the next centre is always at the point of least overlap.
std::size_t countGreedyCentres(const SortedPoints& points, const ReconstructionOptions& options) {
  std::vector<float> overlap(points.size(), 0);
  const SupportRule rule = supportRule(points, options);
  Neighbourhood scratch;
  for (std::size_t count = 0;; ++count) {
    const auto least = std::min_element(overlap.begin(), overlap.end());
    if (*least >= float(options.overlap)) return count;
    const FittedCentre c = fitCentre(points, std::size_t(least - overlap.begin()), rule, 0, scratch);
    const auto sigma = float(c.sigma);
    for (std::size_t j = 0; j < scratch.selected().size(); ++j)
      overlap[scratch.selected()[j]] += wendland(scratch.selection().r[j] / sigma);
  }
}

TEST(Centres, CoverEveryPoint) {
  const SortedPoints points = sortPoints(spherePoints(6000, 20, 0.3), {});
  for (const double overlap : {0.5, 4.0}) {
    ReconstructionOptions options;
    options.overlap = overlap;
    options.smoothness = 2e-4;
    const CentreSelection selection = selectCentres(points, options);
    const std::vector<double> expected = overlaps(points, selection.centres);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_GE(expected[i], overlap - 1e-4);
      EXPECT_NEAR(double(selection.overlap[i]), expected[i], 1e-4 * expected[i]);
    }
  }
}

// What the selection says of the function at the points is what the function is there.
TEST(Centres, KnowTheFunctionAtThePoints) {
  ReconstructionOptions options;
  options.smoothness = 2e-4;
  const SortedPoints points = sortPoints(spherePoints(3000, 15, 0.3), options);
  const CentreSelection selection = selectCentres(points, options);
  const CsrbfModel model(selection.centres);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(selection.base[i], model.sample(points.position(i)).value, 1e-4f);
}

// On surfaces a point lies in 14 to 16 supports, so M is about 14 N / n.
TEST(Centres, LieAsDenselyAsTheoryPredicts) {
  ReconstructionOptions options;
  options.smoothness = 2e-4;
  const SortedPoints points = sortPoints(spherePoints(10000, 28, 0.3), options);
  double incidences = 0;
  for (const Centre& c : selectCentres(points, options).centres)
    for (std::size_t i = 0; i < points.size(); ++i)
      incidences += glm::distance(points.position(i), c.position) < c.support;
  EXPECT_GT(incidences / double(points.size()), 13);
  EXPECT_LT(incidences / double(points.size()), 17);
}

TEST(Centres, BatchesComeCloseToTheGreedyChoice) {
  ReconstructionOptions options;
  options.smoothness = 1.2e-4;
  const SortedPoints points = sortPoints(spherePoints(8000, 25, 0.2), options);
  const double greedy = double(countGreedyCentres(points, options));
  const double batched = double(selectCentres(points, options).centres.size());
  EXPECT_GT(greedy, 150);
  EXPECT_NEAR(batched / greedy, 1, 0.06);
}

// Derived: for white noise s the smoothness has a cliff at T_crit = 1.905 s h / L².
TEST(Centres, ANoisyPlaneShowsTheCliff) {
  const auto countAt = [](const SortedPoints& points, double ratio) {
    ReconstructionOptions options;
    options.smoothness = ratio * 1.905 * 0.3 / (points.diagonal * points.diagonal);
    return double(selectCentres(points, options).centres.size());
  };
  const SortedPoints points = sortPoints(planePoints(300, 0.3), {});
  EXPECT_NEAR(countAt(points, 1.5) / 2972, 1, 0.1);
  EXPECT_NEAR(countAt(points, 2) / 1052, 1, 0.1);
  EXPECT_NEAR(countAt(points, 4) / 532, 1, 0.1);
  const SortedPoints small = sortPoints(planePoints(60, 0.3), {});
  EXPECT_GT(countAt(small, 0.3), 0.7 * double(small.size()));  // almost every point becomes a centre
}

TEST(Centres, TheThreadCountChangesNothing) {
  const SortedPoints points = sortPoints(spherePoints(5000, 20, 0.2), {});
  setThreadCount(1);
  const std::vector<Centre> one = selectCentres(points, {}).centres;
  setThreadCount(5);
  const std::vector<Centre> five = selectCentres(points, {}).centres;
  setThreadCount(0);
  ASSERT_EQ(one.size(), five.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].position, five[i].position);
    EXPECT_EQ(one[i].support, five[i].support);
    EXPECT_EQ(one[i].quadric.f, five[i].quadric.f);
    EXPECT_EQ(one[i].quadric.xy, five[i].quadric.xy);
  }
}

TEST(Centres, StopWhenCancelledInTheMiddle) {
  const SortedPoints points = sortPoints(noisySphere(), {});
  ProgressSink sink;
  sink.report = [&](double fraction) { sink.cancel = fraction > 0.2; };
  EXPECT_THROW(selectCentres(points, {}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
