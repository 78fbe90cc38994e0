#include "core/rbf/global/global_system.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/global_sites.h"

namespace sonoskin {
namespace {

using test::kAllBases;

// Counts beside whole chunks and stripes.
TEST(GlobalSystem, TheProductEqualsTheMatrix) {
  for (const int count : {1, 63, 64, 65, 300, 2500})
    for (const GlobalBasis b : kAllBases) {
      const Sites sites = test::randomSites(count);
      const Eigen::VectorXd w = test::randomVector(sites.size());
      const Eigen::VectorXd expected = kernelMatrix({b, 0.5}, sites) * w;
      EXPECT_LT((kernelProduct({b, 0.5}, sites, w) - expected).norm(), 1e-11 * double(count))
          << count << int(b);
      EXPECT_LT((kernelSums({b, 0.5}, sites, w, sites) - expected).norm(), 1e-11 * double(count));
      if (count > 300) break;
    }
}

TEST(GlobalSystem, TheMatrixHoldsTheKernel) {
  const Sites sites = test::randomSites(70);
  for (const GlobalBasis b : kAllBases) {
    const Eigen::MatrixXd matrix = kernelMatrix({b, 0.5}, sites);
    for (std::size_t i = 0; i < 70; i += 3)
      for (std::size_t j = 0; j < 70; ++j) {
        const glm::dvec3 d = sites[i] - sites[j];
        EXPECT_NEAR(matrix(Eigen::Index(i), Eigen::Index(j)), kernelValue({b, 0.5}, glm::dot(d, d)), 1e-14);
      }
  }
}

TEST(GlobalSystem, GradientsEqualDifferences) {
  const Sites sites = test::randomSites(100), places = test::randomSites(9, 7);
  const Eigen::VectorXd w = test::randomVector(sites.size());
  const double step = 1e-5;
  for (const GlobalBasis b : kAllBases) {
    const auto gradients = kernelGradients({b, 0.8}, sites, w, places);
    for (int axis = 0; axis < 3; ++axis) {
      Sites above, below;
      glm::dvec3 shift(0);
      shift[axis] = step;
      for (std::size_t i = 0; i < places.size(); ++i) {
        above.push_back(places[i] + shift);
        below.push_back(places[i] - shift);
      }
      const Eigen::VectorXd difference =
          kernelSums({b, 0.8}, sites, w, above) - kernelSums({b, 0.8}, sites, w, below);
      for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(gradients[i][axis], difference[Eigen::Index(i)] / (2 * step), 1e-5) << int(b);
    }
  }
}

TEST(GlobalSystem, AGradientAtACentreIsFinite) {
  const Sites sites = test::randomSites(10);
  for (const GlobalBasis b : kAllBases)
    for (const glm::dvec3& g : kernelGradients({b, 0.5}, sites, test::randomVector(10), sites))
      EXPECT_TRUE(std::isfinite(g.x + g.y + g.z)) << int(b);
}

TEST(GlobalSystem, DoesNotDependOnTheThreads) {
  const Sites sites = test::randomSites(3000);
  const Eigen::VectorXd w = test::randomVector(sites.size());
  setThreadCount(1);
  const Eigen::VectorXd product = kernelProduct({}, sites, w), sums = kernelSums({}, sites, w, sites);
  setThreadCount(2);
  EXPECT_EQ(kernelProduct({}, sites, w), product);
  EXPECT_EQ(kernelSums({}, sites, w, sites), sums);
  setThreadCount(0);
}

TEST(GlobalSystem, CanBeCancelled) {
  const Sites sites = test::randomSites(200);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(kernelProduct({}, sites, test::randomVector(200), Progress(sink)), Cancelled);
  EXPECT_THROW(kernelSums({}, sites, test::randomVector(200), sites, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
