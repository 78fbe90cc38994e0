#include "core/classification/classify.h"

#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/classification/data_term.h"
#include "core/classification/pcg.h"
#include "tests/support/applied.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

using test::grid;

ClassificationOptions optionsForTests() {
  ClassificationOptions o;
  o.isoValue = 0.35;
  return o;
}

// diag(c) + K with its columns probed one by one.
Eigen::SparseMatrix<double> assembled(const NeighbourTerms& k, const DataTerm& term) {
  const std::size_t n = k.geometry().voxels();
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<float> unit(n, 0.0f);
  for (std::size_t column = 0; column < n; ++column) {
    unit[column] = 1;
    const std::vector<float> ku = test::applied(k, unit);
    for (std::size_t row = 0; row < n; ++row)
      if (ku[row] != 0) entries.emplace_back(int(row), int(column), double(ku[row]));
    unit[column] = 0;
    entries.emplace_back(int(column), int(column), double(term.diagonal[column]));
  }
  Eigen::SparseMatrix<double> a{Eigen::Index(n), Eigen::Index(n)};
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

TEST(Classify, EqualsADirectSolve) {
  setThreadCount(1);  // the probing below starts a team of threads per column
  const Geometry g = grid({12, 12, 12}, {0.3, 0.3, 0.6});
  const auto volume = test::speckledSphere(g, {1.7, 1.7, 3.3}, 1.0, 0.2);
  const auto options = optionsForTests();
  const Smoothed smoothed = smooth(volume, options);
  const DataTerm term = dataTerm({volume, smoothed.lowPassed, options});
  const NeighbourTerms k = neighbourTerms(smoothed, options);
  const Solution solution = solvePcg(k, term, 1e-6);

  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> direct(assembled(k, term));
  ASSERT_EQ(direct.info(), Eigen::Success);
  Eigen::VectorXd b(Eigen::Index(g.voxels()));
  for (std::size_t i = 0; i < g.voxels(); ++i) b[Eigen::Index(i)] = double(term.right[i]);
  const Eigen::VectorXd expected = direct.solve(b);
  for (std::size_t i = 0; i < g.voxels(); ++i)
    ASSERT_NEAR(solution.u[i], expected[Eigen::Index(i)], 1e-5) << "voxel " << i;
  setThreadCount(0);
}

TEST(Classify, WithoutBetaIsTheClosedForm) {
  const Geometry g = grid({20, 18, 16});
  const auto volume = test::speckledSphere(g, {9, 9, 8}, 5, 0.2);
  auto options = optionsForTests();
  options.beta = 0;
  const Smoothed smoothed = smooth(volume, options);
  const DataTerm term = dataTerm({volume, smoothed.lowPassed, options});
  const auto u = classify(volume, smoothed, options);
  for (std::size_t i = 0; i < g.voxels(); ++i) ASSERT_NEAR(u.data[i], term.right[i] / term.diagonal[i], 1e-6);
}

TEST(Classify, IsBrightOnTheSurfaceAndDarkAwayFromIt) {
  const Geometry g = grid({48, 48, 48});
  const glm::dvec3 centre(23.5);
  const auto volume = test::speckledSphere(g, centre, 14, 0.1);
  const auto options = optionsForTests();
  const auto u = classify(volume, smooth(volume, options), options);
  double onSurface = 1, away = 0;
  for (int k = 4; k < 44; ++k)
    for (int j = 4; j < 44; ++j)
      for (int i = 4; i < 44; ++i) {
        const double distance = std::abs(glm::length(glm::dvec3(i, j, k) - centre) - 14.7);
        if (distance < 0.3) onSurface = std::min(onSurface, double(u.at(i, j, k)));
        if (distance > 8) away = std::max(away, double(u.at(i, j, k)));
      }
  EXPECT_GT(onSurface, 0.5);
  EXPECT_LT(away, 0.1);
}

TEST(Classify, StaysBetweenZeroAndTheTarget) {
  const auto volume = test::speckledSphere(grid({24, 24, 24}), {11, 12, 13}, 7, 0.6);
  auto options = optionsForTests();
  options.target = 0.9;
  const auto u = classify(volume, smooth(volume, options), options);
  for (const float value : u.data) {
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 0.9f);
  }
}

TEST(Classify, OvershootsByLessThanTwoPercentBeforeTheClamp) {
  const auto volume = test::speckledSphere(test::grid({40, 40, 24}, {0.3, 0.3, 0.9}), {6, 6, 11}, 4, 0.5);
  const auto options = optionsForTests();
  const Smoothed smoothed = smooth(volume, options);
  const NeighbourTerms k = neighbourTerms(smoothed, options);
  const Solution solution = solvePcg(k, dataTerm({volume, smoothed.lowPassed, options}), 1e-6);
  const auto [least, most] = std::minmax_element(solution.u.begin(), solution.u.end());
  EXPECT_GT(*least, -0.02 * options.target);
  EXPECT_LT(*most, 1.02 * options.target);
}

TEST(Classify, LooserToleranceStaysNearTheSolution) {
  const auto volume = test::speckledSphere(test::grid({40, 40, 24}, {0.3, 0.3, 0.9}), {6, 6, 11}, 4, 0.3);
  auto options = optionsForTests();
  const Smoothed smoothed = smooth(volume, options);
  options.tolerance = 1e-7;
  const auto exact = classify(volume, smoothed, options);
  struct Case {
    double tolerance, worst, rms;
  };
  for (const auto& [tolerance, worst, rms] : {Case{1e-3, 0.02, 2e-4}, Case{1e-4, 0.004, 2e-5}}) {
    options.tolerance = tolerance;
    const auto u = classify(volume, smoothed, options);
    double squares = 0;
    for (std::size_t i = 0; i < u.data.size(); ++i) {
      ASSERT_NEAR(u.data[i], exact.data[i], worst);
      squares += std::pow(double(u.data[i]) - double(exact.data[i]), 2);
    }
    EXPECT_LT(std::sqrt(squares / double(u.data.size())), rms) << tolerance;
  }
}

// A mirrored volume gives the mirrored result.
TEST(Classify, DoesNotPreferADirection) {
  const Geometry g = grid({18, 14, 12}, {0.3, 0.4, 0.5});
  const auto volume = test::speckledSphere(g, {2.5, 2.6, 2.8}, 1.6, 0.3);
  const auto mirrored = [&](const Volume<float>& v, int axis) {
    Volume<float> result(g);
    for (int k = 0; k < g.dims.z; ++k)
      for (int j = 0; j < g.dims.y; ++j)
        for (int i = 0; i < g.dims.x; ++i) {
          glm::ivec3 at(i, j, k);
          at[axis] = g.dims[axis] - 1 - at[axis];
          result.at(i, j, k) = v.at(at.x, at.y, at.z);
        }
    return result;
  };
  auto options = optionsForTests();
  options.tolerance = 1e-6;
  const auto u = classify(volume, smooth(volume, options), options);
  for (int axis = 0; axis < 3; ++axis) {
    const auto other = mirrored(volume, axis);
    const auto v = mirrored(classify(other, smooth(other, options), options), axis);
    for (std::size_t i = 0; i < u.data.size(); ++i) ASSERT_NEAR(u.data[i], v.data[i], 2e-5) << axis;
  }
}

// Swapping the roles of the axes swaps the result.
TEST(Classify, DoesNotPreferAnAxis) {
  const Geometry g = grid({18, 14, 12}, {0.3, 0.4, 0.5}), turned = grid({12, 18, 14}, {0.5, 0.3, 0.4});
  const auto volume = test::speckledSphere(g, {2.5, 2.6, 2.8}, 1.6, 0.3);
  Volume<float> other(turned);
  const auto turn = [&](int i, int j, int k) { return turned.index(k, i, j); };
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) other.data[turn(i, j, k)] = volume.at(i, j, k);
  auto options = optionsForTests();
  options.tolerance = 1e-6;
  const auto u = classify(volume, smooth(volume, options), options);
  const auto v = classify(other, smooth(other, options), options);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) ASSERT_NEAR(u.at(i, j, k), v.data[turn(i, j, k)], 2e-4);
}

TEST(Classify, DoesNotDependOnTheUnitOfLength) {
  Geometry g = grid({16, 15, 14}, {0.3, 0.3, 0.9});
  auto volume = test::speckledSphere(g, {2.2, 2.2, 6}, 1.5, 0.3);
  const auto options = optionsForTests();
  const auto u = classify(volume, smooth(volume, options), options);
  volume.geometry.spacing *= 4.0;
  const auto v = classify(volume, smooth(volume, options), options);
  for (std::size_t i = 0; i < u.data.size(); ++i) ASSERT_NEAR(u.data[i], v.data[i], 1e-5);
}

TEST(Classify, SameBitsOnAnyNumberOfThreads) {
  const auto volume = test::speckledSphere(grid({21, 20, 19}), {10, 10, 9}, 6, 0.4);
  const auto options = optionsForTests();
  setThreadCount(1);
  const auto one = classify(volume, smooth(volume, options), options);
  setThreadCount(3);
  const auto three = classify(volume, smooth(volume, options), options);
  setThreadCount(0);
  EXPECT_EQ(one.data, three.data);
}

TEST(Classify, RefusesAFlatVolume) {
  EXPECT_THROW(smooth(Volume<float>(grid({20, 20, 2})), optionsForTests()), Error);
}

TEST(Classify, StopsWhenCancelled) {
  const auto volume = test::speckledSphere(grid({24, 24, 24}), {11, 12, 13}, 7, 0.4);
  const auto options = optionsForTests();
  const Smoothed smoothed = smooth(volume, options);
  ProgressSink sink;
  sink.report = [&](double fraction) { sink.cancel = fraction > 0.3; };
  EXPECT_THROW(classify(volume, smoothed, options, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
