#include "core/rbf/global/global_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/expect_error.h"
#include "tests/support/global_sites.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

GlobalOptions accurate(double accuracy) {
  GlobalOptions options;
  options.accuracy = accuracy;
  options.nugget = 0;
  return options;
}

TEST(GlobalFit, ASphereIsCloseToItsSignedDistance) {
  const SurfacePoints points = spherePoints(600, 20);
  for (const GlobalBasis b : test::kAllBases) {
    GlobalOptions options = accurate(0);
    options.basis = b;
    if (b == GlobalBasis::wendland) options.width = 10;
    const GlobalRbf model = fitGlobal(points, options);
    EXPECT_EQ(model.size(), model.report().constraints);
    EXPECT_LT(model.report().largestResidual, 1e-2) << int(b);
    for (const glm::dvec3& n : {glm::dvec3(0.6, 0.8, 0), {-0.48, 0.6, 0.64}}) {
      EXPECT_NEAR(model.value(20.0 * n), 0, 0.1) << int(b);
      EXPECT_NEAR(model.value(20.7 * n), 0.7, 0.15) << int(b);
      EXPECT_NEAR(model.value(19.3 * n), -0.7, 0.15) << int(b);
      EXPECT_NEAR(glm::dot(glm::normalize(model.gradient(20.0 * n)), n), 1, 0.01) << int(b);
    }
  }
}

TEST(GlobalFit, TheGradientEqualsDifferences) {
  for (const GlobalBasis b : test::kAllBases) {
    GlobalOptions options = accurate(0);
    options.basis = b;
    const GlobalRbf model = fitGlobal(spherePoints(200, 10, 0.1), options);
    const double step = 1e-4;
    for (const glm::dvec3 x : {glm::dvec3(6, 8, 0.1), {-3, 9, 4}, {0, 0, 2}})
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 above = x, below = x;
        above[axis] += step, below[axis] -= step;
        EXPECT_NEAR(model.gradient(x)[axis], (model.value(above) - model.value(below)) / (2 * step), 1e-5)
            << int(b);
      }
  }
}

// Millimetres in, millimetres out: the same points ten times as large give ten times the function.
TEST(GlobalFit, ScalesWithItsPoints) {
  const SurfacePoints points = spherePoints(300, 10, 0.1);
  SurfacePoints large = points;
  for (glm::vec3& p : large.positions) p = 10.f * p + glm::vec3(100, 0, 0);
  for (const GlobalBasis b : test::kAllBases) {
    GlobalOptions options = accurate(0);
    options.basis = b;
    options.tolerance = 1e-8;
    const GlobalRbf model = fitGlobal(points, options);
    options.offset *= 10;
    options.width *= 10;
    const GlobalRbf tenfold = fitGlobal(large, options);
    for (const glm::dvec3 x : {glm::dvec3(6, 8, 0.1), {-3, 9, 4}})
      EXPECT_NEAR(tenfold.value(10.0 * x + glm::dvec3(100, 0, 0)), 10 * model.value(x), 0.02) << int(b);
  }
}

TEST(GlobalFit, FewCentresReachTheAccuracy) {
  const SurfacePoints points = spherePoints(4000, 20, 0.1);
  for (const double accuracy : {0.4, 0.15}) {
    const GlobalRbf model = fitGlobal(points, accurate(accuracy));
    EXPECT_LT(model.size(), 6000u);
    EXPECT_EQ(model.report().constraints, 8000u);
    EXPECT_LE(model.report().largestResidual, accuracy);
    EXPECT_LE(model.report().largestOffSurface, 0.5);
    for (std::size_t i = 0; i < points.size(); i += 53)
      EXPECT_LE(std::abs(model.value(glm::dvec3(points.positions[i]))), accuracy);
  }
}

TEST(GlobalFit, MoreAccuracyTakesMoreCentres) {
  const SurfacePoints points = spherePoints(6000, 20, 0.1);
  const GlobalRbf coarse = fitGlobal(points, accurate(0.5)), fine = fitGlobal(points, accurate(0.2));
  EXPECT_GT(fine.size(), coarse.size());
  EXPECT_GT(fine.report().rounds, 1);
}

// A nugget leaves noise out: the surface is smoother, and its centres are missed too.
TEST(GlobalFit, ANuggetIsSmoother) {
  const SurfacePoints points = spherePoints(6000, 20, 0.2);
  GlobalOptions options = accurate(0.5);
  const auto roughness = [&] {
    const GlobalRbf model = fitGlobal(points, options);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); i += 20) {
      const glm::dvec3 n(points.normals[i]);
      sum += 1 - glm::dot(glm::normalize(model.gradient(20.0 * n)), n);
    }
    return sum;
  };
  const double through = roughness();
  options.nugget = 10;
  EXPECT_LT(roughness(), 0.5 * through);
}

// Where points and values are given, every one is met.
TEST(GlobalFit, InterpolatesGivenValues) {
  GlobalPoints points;
  points.sites = test::randomSites(400);
  const Eigen::VectorXd f = test::randomVector(400);
  points.values.assign(f.begin(), f.end());
  points.onSurface = 0;
  GlobalOptions options = accurate(0);
  options.tolerance = 1e-8;
  const GlobalRbf model = fitGlobal(points, options);
  const std::vector<double> values = model.values(points.sites);
  for (std::size_t i = 0; i < 400; ++i) EXPECT_NEAR(values[i], points.values[i], 1e-6);
}

TEST(GlobalFit, RefusesADegreeBelowWhatTheBasisNeeds) {
  const SurfacePoints points = spherePoints(100, 10);
  for (const GlobalBasis b : test::kAllBases)
    for (int degree = -1; degree <= 2; ++degree) {
      GlobalOptions options = accurate(0);
      options.basis = b;
      options.degree = degree;
      if (degree < minimumDegree(b))
        test::expectError([&] { fitGlobal(points, options); }, "needs at least", Error::Kind::usage);
      else
        EXPECT_NO_THROW(fitGlobal(points, options)) << int(b) << " " << degree;
    }
}

TEST(GlobalFit, RefusesPointsThatDoNotDetermineThePolynomial) {
  GlobalPoints plane;
  for (int i = 0; i < 100; ++i) plane.sites.push_back({i % 10, i / 10, 0});
  plane.values.assign(100, 1.0);
  GlobalOptions options = accurate(0);
  options.degree = 2;
  test::expectError([&] { fitGlobal(plane, options); }, "do not determine");
  options.degree = 0;
  EXPECT_NEAR(fitGlobal(plane, options).value({4.5, 4.5, 3}), 1, 1e-6);
}

TEST(GlobalFit, RefusesTooManyCentres) {
  GlobalOptions options = accurate(0);
  options.maxCentres = 1000;
  test::expectError([&] { fitGlobal(spherePoints(2000, 20), options); }, "raise global.accuracy");
}

TEST(GlobalFit, SaysWhereTheSolverDoesNotConverge) {
  GlobalOptions options = accurate(0);
  options.basis = GlobalBasis::gaussian;
  options.width = 100;
  test::expectError([&] { fitGlobal(spherePoints(1000, 20, 0.3), options); }, "did not converge");
}

TEST(GlobalFit, DoesNotDependOnTheThreads) {
  const SurfacePoints points = spherePoints(3000, 20, 0.1);
  setThreadCount(1);
  const GlobalRbf one = fitGlobal(points, accurate(0.25));
  setThreadCount(2);
  const GlobalRbf two = fitGlobal(points, accurate(0.25));
  setThreadCount(0);
  EXPECT_EQ(one.parts().weights, two.parts().weights);
  EXPECT_EQ(one.parts().centres.x, two.parts().centres.x);
  EXPECT_EQ(one.value({1, 2, 3}), two.value({1, 2, 3}));
}

TEST(GlobalFit, CanBeCancelledAtAnyTime) {
  const SurfacePoints points = spherePoints(3000, 20, 0.1);
  for (const double until : {0.0, 0.1, 0.3, 0.5}) {
    ProgressSink sink;
    sink.report = [&](double fraction) {
      if (fraction >= until) sink.cancel = true;
    };
    EXPECT_THROW(fitGlobal(points, accurate(0.25), Progress(sink)), Cancelled);
  }
}

}  // namespace
}  // namespace sonoskin
