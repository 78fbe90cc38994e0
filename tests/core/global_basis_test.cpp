#include "core/rbf/global/global_basis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/rbf/global/global_kernels.h"
#include "tests/support/global_sites.h"

namespace sonoskin {
namespace {

using test::kAllBases;

// φ'(r)/r, from r².
double kernelSlope(const RadialKernel& kernel, double squared) {
  KernelChunk chunk = KernelChunk::Constant(1, squared);
  withKernel(kernel, [&](const auto& k) { k.slope(chunk); });
  return chunk[0];
}

TEST(GlobalBasis, HasTheValuesOfItsFormula) {
  const double r = 0.6, w = 1.5, c = 1 / (w * w), t = r / w;
  const auto value = [&](GlobalBasis b) { return kernelValue({b, w}, r * r); };
  EXPECT_NEAR(value(GlobalBasis::biharmonic), -r, 1e-15);
  EXPECT_NEAR(value(GlobalBasis::triharmonic), r * r * r, 1e-15);
  EXPECT_NEAR(value(GlobalBasis::thinPlate), r * r * std::log(r), 1e-14);
  EXPECT_NEAR(value(GlobalBasis::gaussian), std::exp(-c * r * r), 1e-14);
  EXPECT_NEAR(value(GlobalBasis::multiquadric), -std::sqrt(1 + c * r * r), 1e-15);
  EXPECT_NEAR(value(GlobalBasis::inverseMultiquadric), 1 / std::sqrt(1 + c * r * r), 1e-15);
  EXPECT_NEAR(value(GlobalBasis::wendland), std::pow(1 - t, 4) * (4 * t + 1), 1e-15);
  EXPECT_EQ(kernelValue({GlobalBasis::wendland, 0.5}, r * r), 0);
}

TEST(GlobalBasis, AtTheCentreItIsFiniteAndHasNoSlopeToSpeakOf) {
  for (const GlobalBasis b : kAllBases) {
    EXPECT_TRUE(std::isfinite(kernelValue({b, 1}, 0))) << int(b);
    EXPECT_TRUE(std::isfinite(kernelSlope({b, 1}, 0))) << int(b);
  }
  EXPECT_EQ(kernelValue({GlobalBasis::thinPlate, 1}, 0), 0);
}

TEST(GlobalBasis, TheSlopeEqualsDifferences) {
  const double step = 1e-5;
  for (const GlobalBasis b : kAllBases)
    for (const double r : {0.05, 0.3, 0.9, 1.4}) {
      const RadialKernel kernel{b, 1.2};
      const double above = kernelValue(kernel, (r + step) * (r + step));
      const double below = kernelValue(kernel, (r - step) * (r - step));
      EXPECT_NEAR(kernelSlope(kernel, r * r) * r, (above - below) / (2 * step), 1e-8) << int(b);
    }
}

// λᵀAλ > 0 for every λ without a polynomial part of the minimum degree: the signs are right.
TEST(GlobalBasis, TheEnergyIsPositiveOnTheConstrainedSpace) {
  const Sites sites = test::randomSites(40);
  for (const GlobalBasis b : kAllBases) {
    const Eigen::MatrixXd matrix = kernelMatrix({b, 0.5}, sites);
    const PolynomialSpace polynomials(sites, minimumDegree(b));
    for (unsigned seed = 0; seed < 20; ++seed) {
      Eigen::VectorXd v = test::randomVector(sites.size(), seed);
      polynomials.project(v);
      EXPECT_GT(v.dot(matrix * v), 1e-3 * v.squaredNorm()) << int(b);
    }
  }
}

// One degree less, and the energy of some λ is negative.
TEST(GlobalBasis, TheMinimumDegreeIsNeeded) {
  const Sites sites = test::randomSites(40);
  for (const GlobalBasis b : kAllBases) {
    if (minimumDegree(b) < 0) continue;
    const Eigen::MatrixXd matrix = kernelMatrix({b, 0.5}, sites);
    const PolynomialSpace polynomials(sites, minimumDegree(b) - 1);
    double least = 1;
    for (int axis = 0; axis < 4; ++axis) {
      Eigen::VectorXd v = monomialMatrix(sites, 1).col(axis);
      polynomials.project(v);
      least = std::min(least, v.dot(matrix * v));
    }
    EXPECT_LT(least, 0) << int(b);
  }
}

// Positions in other units: the same function, if the diagonal is measured by the kernel's variation.
TEST(GlobalBasis, ADiagonalMeasuredByTheVariationKeepsTheFit) {
  const Sites sites = test::randomSites(60);
  const Eigen::VectorXd values = test::randomVector(sites.size());
  Sites scaled;
  for (std::size_t i = 0; i < sites.size(); ++i) scaled.push_back(7.0 * sites[i]);
  for (const GlobalBasis b : kAllBases) {
    const RadialKernel kernel{b, 0.5}, wide{b, 3.5};
    const GlobalSystem one{sites, kernel, 1, 0.3 * kernelVariation(kernel, 0.1)};
    const GlobalSystem seven{scaled, wide, 1, 0.3 * kernelVariation(wide, 0.7)};
    EXPECT_GT(one.nugget, 0) << int(b);
    const SolverOptions exact{1e-13, 100, {}};
    const GlobalSolution a = solveGlobal(one, values, {}, exact), c = solveGlobal(seven, values, {}, exact);
    for (const glm::dvec3 p : {glm::dvec3(0.1, 0.2, -0.3), {0.8, -0.5, 0}})
      EXPECT_NEAR(test::valueAt(one, a, p), test::valueAt(seven, c, 7.0 * p), 1e-6) << int(b);
  }
}

}  // namespace
}  // namespace sonoskin
