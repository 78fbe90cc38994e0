#include "core/rbf/compact/thesis_centres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/rbf/basis.h"
#include "core/rbf/compact/lambda_fit.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

ReconstructionOptions thesisOptions(double smoothness) {
  ReconstructionOptions options;
  options.method = ReconstructionMethod::thesis;
  options.smoothness = smoothness;
  return options;
}

TEST(ThesisCentres, TheSearchFindsTheFirstMinimum) {
  int calls = 0;
  const auto wave = [&](double x) {
    ++calls;
    return std::cos(x);  // minima at π, 3 π, ...
  };
  EXPECT_NEAR(thesisMinimum(wave, 0.01, 12, 1e-6), 3.14159265, 1e-5);
  EXPECT_GT(calls, 20);
  EXPECT_LT(calls, 100);
  EXPECT_EQ(thesisMinimum([](double x) { return 1 / x; }, 0.01, 7, 1e-6), 7);
  EXPECT_NEAR(thesisMinimum([](double x) { return x; }, 0.01, 7, 1e-6), 0.01, 1e-6);
}

TEST(ThesisCentres, InfluencesHaveTheMeanOneAndNoConfidence) {
  SurfacePoints cloud = spherePoints(2000, 10, 0.1);
  const SortedPoints points = thesisPoints(cloud);
  EXPECT_NEAR(std::accumulate(points.influence.begin(), points.influence.end(), 0.0) / 2000, 1, 1e-4);
  for (std::size_t i = 0; i < cloud.size(); i += 3) cloud.confidence[i] = 0.1f;
  EXPECT_EQ(thesisPoints(cloud).influence, points.influence);
}

// The literal rule, by brute force: every centre lies at the point that is least covered by those before it, and the
// last one leaves none below the overlap.
TEST(ThesisCentres, EachIsAtTheLeastCoveredPoint) {
  const ReconstructionOptions options = thesisOptions(2e-4);
  const SortedPoints points = thesisPoints(spherePoints(3000, 15, 0.2));
  const CentreSelection selection = selectThesisCentres(points, options);
  std::vector<float> overlap(points.size(), 0);
  for (const Centre& c : selection.centres) {
    const float least = *std::min_element(overlap.begin(), overlap.end());
    float own = 1e9f;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.position(i) == c.position) own = overlap[i];
    EXPECT_NEAR(own, least, 1e-4f);
    EXPECT_LT(least, float(options.overlap));
    for (std::size_t i = 0; i < points.size(); ++i)
      overlap[i] += wendland(glm::distance(points.position(i), c.position) / c.support);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GE(overlap[i], float(options.overlap) - 1e-4f);
    EXPECT_NEAR(selection.overlap[i], overlap[i], 1e-3f);
  }
}

TEST(ThesisCentres, SupportsStayWithinTheirLimits) {
  const SortedPoints points = thesisPoints(planePoints(60));
  const std::vector<Centre> centres = selectThesisCentres(points, thesisOptions(1e-4)).centres;
  EXPECT_FALSE(centres.empty());
  for (const Centre& c : centres)
    EXPECT_NEAR(c.support, 0.07f * 60, 0.1f);  // a plane lets it grow to the limit
}

// What is reported is the global error of the plain form, which is the normalised one times its divisor.
TEST(ThesisCentres, TheFitReportsThePlainForm) {
  const SurfacePoints cloud = spherePoints(4000, 15, 0.1);
  ReconstructionOptions options = thesisOptions(3e-4);
  options.fitWeights = true;
  options.regularisation = 1e-5;
  const CsrbfModel model = fitCsrbf(cloud, options);
  const SortedPoints points = thesisPoints(cloud);
  double sum = 0, weights = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CsrbfModel::Sample s = model.sample(points.position(k));
    sum += double(points.influence[k]) * std::pow(double(s.value * s.coverage), 2);
    weights += double(points.influence[k]);
    EXPECT_NEAR(s.value, 0, 0.5f);
  }
  const double error = std::sqrt(sum / weights) / points.diagonal;
  EXPECT_NEAR(model.report().globalErrorWithWeights.value(), error, 1e-3 * error);
  EXPECT_LT(error, model.report().globalError);
}

TEST(ThesisCentres, StopWhenCancelledInTheMiddle) {
  ProgressSink sink;
  sink.report = [&](double fraction) { sink.cancel = fraction > 0.3; };
  EXPECT_THROW(fitCsrbf(noisySphere(), thesisOptions(1e-4), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
