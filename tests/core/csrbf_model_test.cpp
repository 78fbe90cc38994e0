#include "core/rbf/compact/csrbf_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/rbf/compact/centres.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

ReconstructionOptions smooth(double smoothness) {
  ReconstructionOptions options;
  options.smoothness = smoothness;
  return options;
}

TEST(CsrbfModel, APlaneIsItsSignedDistance) {
  const CsrbfModel model = fitCsrbf(planePoints(40), {});
  for (const glm::vec3 x : {glm::vec3(20, 20, 0.5f), {11, 25, -1}, {30, 14, 2}}) {
    const CsrbfModel::Sample s = model.sample(x);
    EXPECT_NEAR(s.value, x.z, 1e-4f);
    EXPECT_GT(s.coverage, 0.1f);
    EXPECT_LT(glm::distance(model.gradient(x), glm::vec3(0, 0, 1)), 1e-3f);
  }
}

TEST(CsrbfModel, APlaneInAnyDirectionIsItsSignedDistance) {
  const glm::vec3 u = glm::normalize(glm::vec3(2, 1, -1)),
                  v = glm::normalize(glm::cross(u, glm::vec3(0, 1, 3))), n = glm::cross(u, v),
                  shift(100, -40, 30);
  SurfacePoints points = planePoints(40);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 p = points.positions[i];
    points.positions[i] = shift + p.x * u + p.y * v;
    points.normals[i] = n;
  }
  const CsrbfModel model = fitCsrbf(points, {});
  for (const glm::vec3 x : {glm::vec3(20, 20, 0.5f), {11, 25, -1}, {30, 14, 2}})
    EXPECT_NEAR(model.sample(shift + x.x * u + x.y * v + x.z * n).value, x.z, 1e-3f);
}

TEST(CsrbfModel, ASphereIsCloseToItsSignedDistance) {
  const SurfacePoints points = spherePoints(20000, 40);
  const CsrbfModel model = fitCsrbf(points, smooth(1e-5));
  for (std::size_t i = 0; i < points.size(); i += 97) {
    EXPECT_NEAR(model.sample(points.positions[i]).value, 0, 0.01f);
    EXPECT_NEAR(model.sample(1.02f * points.positions[i]).value, 0.8f, 0.03f);
    EXPECT_LT(model.sample(0.98f * points.positions[i]).value, -0.75f);
    EXPECT_NEAR(glm::length(model.gradient(points.positions[i])), 1, 0.01f);
  }
}

TEST(CsrbfModel, TheGradientEqualsDifferences) {
  const SurfacePoints points = noisySphere();
  ReconstructionOptions options = smooth(2e-4);
  options.fitWeights = true;
  const CsrbfModel model = fitCsrbf(points, options);
  const float step = 0.02f;
  for (std::size_t i = 0; i < points.size(); i += 501) {
    const glm::vec3 x = 1.01f * points.positions[i];
    const glm::vec3 g = model.gradient(x);
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 a = x, b = x;
      a[axis] -= step, b[axis] += step;
      EXPECT_NEAR(g[axis], (model.sample(b).value - model.sample(a).value) / (2 * step), 2e-3f);
    }
  }
}

TEST(CsrbfModel, IsUndefinedOutsideAllSupports) {
  const CsrbfModel model = fitCsrbf(spherePoints(2000, 10), {});
  for (const glm::vec3 x : {glm::vec3(0), glm::vec3(30, 0, 0), glm::vec3(1e9f), glm::vec3(0, 0, -40)}) {
    EXPECT_TRUE(std::isnan(model.sample(x).value));
    EXPECT_EQ(model.sample(x).coverage, 0);
    EXPECT_EQ(model.gradient(x), glm::vec3(0));
  }
  EXPECT_TRUE(std::isnan(CsrbfModel().sample({0, 0, 0}).value));
}

// The index must find every centre that reaches a place.
TEST(CsrbfModel, SamplesEqualTheSumOverAllCentres) {
  const SurfacePoints points = spherePoints(3000, 10, 0.1);
  const CsrbfModel model = fitCsrbf(points, smooth(1e-4));
  for (std::size_t i = 0; i < points.size(); i += 37) {
    const glm::vec3 x = (0.9f + 0.2f * float(i) / 3000) * points.positions[i];
    double weighted = 0, coverage = 0;
    for (const Centre& c : model.centres()) {
      const double t = double(glm::distance(x, c.position) / c.support);
      const double phi = t < 1 ? std::pow(1 - t, 4) * (4 * t + 1) : 0;
      const glm::vec3 d = x - c.position;
      weighted += phi * double(c.quadric.value(d.x, d.y, d.z) + c.lambda);
      coverage += phi;
    }
    EXPECT_NEAR(double(model.sample(x).coverage), coverage, 1e-4);
    EXPECT_NEAR(double(model.sample(x).value), weighted / coverage, 1e-4);
  }
}

// One centre of a cloud that was turned and moved, L and h held: the same support, the same quadric, the same error.
TEST(CsrbfModel, ARigidMotionMovesTheFit) {
  const SurfacePoints points = spherePoints(5000, 20, 0.1);
  const glm::mat3 turn(glm::normalize(glm::vec3(2, 1, -1)), glm::normalize(glm::vec3(1, -1, 1)),
                       glm::normalize(glm::vec3(0, -1, -1)));
  ASSERT_NEAR(std::abs(glm::determinant(turn)), 1, 1e-5f);
  SurfacePoints moved = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    moved.positions[i] = turn * points.positions[i] + glm::vec3(3, -8, 11);
    moved.normals[i] = turn * points.normals[i];
  }
  const SupportRule rule = supportRule(sortPoints(points, {}), {});
  const auto fitAt = [&](const SurfacePoints& p, std::uint32_t index) {
    const SortedPoints sorted = sortPoints(p, {});
    const auto& order = sorted.grid.order();
    Neighbourhood scratch;
    return fitCentre(sorted, std::size_t(std::find(order.begin(), order.end(), index) - order.begin()), rule,
                     0, scratch);
  };
  for (const std::uint32_t index : {0u, 777u, 4001u}) {
    const FittedCentre still = fitAt(points, index), turned = fitAt(moved, index);
    EXPECT_NEAR(turned.sigma / still.sigma, 1, 1e-3);
    EXPECT_NEAR(turned.fit.meanSquare / still.fit.meanSquare, 1, 1e-2);
    const GlobalQuadric a = toGlobal(still.fit.quadric, still.frame),
                        b = toGlobal(turned.fit.quadric, turned.frame);
    for (const glm::vec3 x : {glm::vec3(0.5f, 0.2f, -0.3f), {-1, 0.7f, 0.1f}, {0.4f, 1, 0.9f}}) {
      const glm::vec3 y = turn * x;
      EXPECT_NEAR(a.value(x.x, x.y, x.z), b.value(y.x, y.y, y.z), 1e-3f);
    }
  }
}

// All normals turned: S changes its sign and nothing else does.
TEST(CsrbfModel, TurnedNormalsTurnTheSign) {
  SurfacePoints points = spherePoints(3000, 10, 0.1);
  const CsrbfModel model = fitCsrbf(points, {});
  for (glm::vec3& n : points.normals) n = -n;
  const CsrbfModel turned = fitCsrbf(points, {});
  ASSERT_EQ(model.centres().size(), turned.centres().size());
  for (std::size_t i = 0; i < points.size(); i += 50)
    EXPECT_NEAR(model.sample(1.03f * points.positions[i]).value,
                -turned.sample(1.03f * points.positions[i]).value, 1e-4f);
}

// One centre, fixed: a scale q multiplies σ and S by q; confidences times a constant change nothing.
TEST(CsrbfModel, ScaleAndConfidenceActAsTheyShould) {
  const SurfacePoints points = spherePoints(5000, 20, 0.1);
  SurfacePoints scaled = points;
  for (glm::vec3& p : scaled.positions) p *= 4.f;
  SurfacePoints weighted = points;
  for (float& c : weighted.confidence) c = 0.25f;
  const auto fitOne = [](const SurfacePoints& p) {
    const SortedPoints sorted = sortPoints(p, {});
    Neighbourhood scratch;
    return fitCentre(sorted, 321, supportRule(sorted, {}), 0, scratch);
  };
  const FittedCentre one = fitOne(points), four = fitOne(scaled), quarter = fitOne(weighted);
  EXPECT_NEAR(four.sigma / one.sigma, 4, 1e-3);
  EXPECT_NEAR(four.fit.quadric.A * 4, one.fit.quadric.A, 1e-5);
  EXPECT_NEAR(four.fit.quadric.F / 4, one.fit.quadric.F, 1e-4);
  EXPECT_NEAR(four.fit.meanSquare / 16, one.fit.meanSquare, 1e-3 * one.fit.meanSquare);
  EXPECT_NEAR(quarter.sigma, one.sigma, 1e-5);
  EXPECT_NEAR(quarter.fit.quadric.A, one.fit.quadric.A, 1e-7);
}

// A low confidence takes influence from wrong points.
TEST(CsrbfModel, ConfidencePullsTheSurface) {
  SurfacePoints points = planePoints(40);
  for (std::size_t i = 0; i < points.size(); i += 2) {
    points.positions[i].z = 1;
    points.confidence[i] = 0.05f;
  }
  const float height = -fitCsrbf(points, smooth(1e-3)).sample({20, 20, 0}).value;
  EXPECT_GT(height, 0);
  EXPECT_LT(height, 0.2f);
}

TEST(CsrbfModel, WithoutConfidenceAllPointsCountTheSame) {
  SurfacePoints points = planePoints(40, 0.3), uneven = points;
  for (std::size_t i = 0; i < points.size(); i += 3) uneven.confidence[i] = 0.05f;
  ReconstructionOptions off = smooth(1e-3);
  off.confidence = false;
  EXPECT_EQ(fitCsrbf(uneven, off).sample({20, 20, 0}).value, fitCsrbf(points, off).sample({20, 20, 0}).value);
  EXPECT_NE(fitCsrbf(uneven, smooth(1e-3)).sample({20, 20, 0}).value,
            fitCsrbf(points, smooth(1e-3)).sample({20, 20, 0}).value);
}

void expectError(SurfacePoints points, const std::string& words) {
  try {
    fitCsrbf(points, {});
    ADD_FAILURE() << "expected: " << words;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
}

TEST(CsrbfModel, RefusesPointsThatSpanNoSurface) {
  const SurfacePoints good = spherePoints(100, 10);
  expectError(spherePoints(11, 10), "at least 12");
  SurfacePoints bad = good;
  bad.positions[7].y = std::numeric_limits<float>::quiet_NaN();
  expectError(bad, "point 7 has a coordinate");
  bad = good;
  bad.normals[8] = glm::vec3(0);
  expectError(bad, "point 8 has no normal");
  bad = good;
  bad.confidence[9] = 0;
  expectError(bad, "point 9 has the confidence");
  bad = good;
  bad.normals.pop_back();
  expectError(bad, "incomplete");
  bad = good;
  for (std::size_t i = 0; i < bad.size(); ++i) bad.positions[i] = float(i) * glm::vec3(1, 2, 3);
  expectError(bad, "one line");
  for (glm::vec3& p : bad.positions) p = {1, 2, 3};
  expectError(bad, "one line");
}

TEST(CsrbfModel, BearsCopiesAndVeryFewPoints) {
  SurfacePoints points = spherePoints(12, 10);
  const CsrbfModel few = fitCsrbf(points, {});
  EXPECT_GT(few.centres().size(), 0u);
  for (const Centre& c : few.centres()) EXPECT_TRUE(std::isfinite(c.quadric.f) && std::isfinite(c.support));
  points = spherePoints(500, 10);
  for (int copy = 0; copy < 30; ++copy) {
    points.positions.push_back(points.positions[3]);
    points.normals.push_back(points.normals[3]);
    points.confidence.push_back(1);
  }
  const CsrbfModel copies = fitCsrbf(points, {});
  for (const glm::vec3& p : points.positions) EXPECT_TRUE(std::isfinite(copies.sample(p).value));
}

// Whatever the moment. A tenth of a second is asked for; a test must bear busy machines.
TEST(CsrbfModel, StopsSoonAfterEveryMoment) {
  const SurfacePoints points = spherePoints(100000, 90, 0.3);
  ReconstructionOptions options = smooth(1e-5);
  options.fitWeights = true;
  for (const double moment : {0.0, 0.05, 0.2, 0.45, 0.7, 0.8, 0.9}) {
    ProgressSink sink;
    std::chrono::steady_clock::time_point cancelled;
    sink.report = [&](double fraction) {
      if (fraction < moment || sink.cancel) return;
      sink.cancel = true;
      cancelled = std::chrono::steady_clock::now();
    };
    EXPECT_THROW(fitCsrbf(points, options, Progress(sink)), Cancelled) << moment;
    const std::chrono::duration<double> late = std::chrono::steady_clock::now() - cancelled;
    EXPECT_LT(late.count(), 0.5) << moment;
  }
}

}  // namespace
}  // namespace sonoskin
