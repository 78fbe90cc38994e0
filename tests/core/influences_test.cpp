#include "core/rbf/influences.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/rbf/sorted_points.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

TEST(Influences, EqualBruteForce) {
  SurfacePoints points = spherePoints(600, 10, 0.2);
  for (std::size_t i = 0; i < points.size(); ++i) points.confidence[i] = 0.2f + 0.001f * float(i);
  ReconstructionOptions options;
  options.neighbours = 7;
  const SortedPoints sorted = sortPoints(points, options);
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    const std::uint32_t i = sorted.grid.order()[s];
    std::vector<double> squares;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const glm::dvec3 d(points.positions[k] - points.positions[i]);
      if (k != i) squares.push_back(glm::dot(d, d));
    }
    std::sort(squares.begin(), squares.end());
    double sum = 0;
    for (std::size_t k = 0; k < 7; ++k) sum += squares[k];
    const double expected = double(points.confidence[i]) * sum / (sorted.spacing * sorted.spacing);
    EXPECT_NEAR(double(sorted.influence[s]), expected, 1e-4 * expected);
  }
}

TEST(Influences, CopiesOfAPointKeepAWeight) {
  SurfacePoints points = spherePoints(100, 10);
  for (int copy = 0; copy < 20; ++copy) {
    points.positions.push_back(points.positions[5]);
    points.normals.push_back(points.normals[5]);
    points.confidence.push_back(1);
  }
  for (const float d : sortPoints(points, {}).influence) EXPECT_GT(d, 0);
}

TEST(Influences, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(sortPoints(spherePoints(100, 10), {}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
