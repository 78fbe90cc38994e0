#include "core/rbf/global/global_polynomial.h"

#include <gtest/gtest.h>

#include "tests/support/global_sites.h"

namespace sonoskin {
namespace {

TEST(GlobalPolynomial, CountsMonomials) {
  EXPECT_EQ(monomialCount(-1), 0);
  EXPECT_EQ(monomialCount(0), 1);
  EXPECT_EQ(monomialCount(1), 4);
  EXPECT_EQ(monomialCount(2), 10);
}

TEST(GlobalPolynomial, TheGradientEqualsDifferences) {
  const std::vector<double> c{1, 2, -3, 0.5, 0.7, -0.2, 0.9, 1.1, -1.3, 0.4};
  const glm::dvec3 p(0.3, -0.8, 0.6);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 above = p, below = p;
    above[axis] += 1e-4, below[axis] -= 1e-4;
    EXPECT_NEAR(polynomialGradient(c, p)[axis],
                (polynomialValue(c, above) - polynomialValue(c, below)) / 2e-4, 1e-9);
  }
}

TEST(GlobalPolynomial, AProjectedVectorHasNoMoments) {
  const Sites sites = test::randomSites(50);
  for (int degree = -1; degree <= 2; ++degree) {
    const PolynomialSpace space(sites, degree);
    Eigen::VectorXd v = test::randomVector(50);
    const Eigen::VectorXd before = v;
    space.project(v);
    EXPECT_LT((monomialMatrix(sites, degree).transpose() * v).norm(), 1e-12);
    EXPECT_EQ(degree < 0, v == before);
    EXPECT_GT(v.norm(), 1);
  }
}

TEST(GlobalPolynomial, AFitFindsItsCoefficients) {
  const Sites sites = test::randomSites(50);
  for (int degree = -1; degree <= 2; ++degree) {
    const Eigen::VectorXd coefficients = test::randomVector(std::size_t(monomialCount(degree)));
    Eigen::VectorXd values = monomialMatrix(sites, degree) * coefficients;
    EXPECT_LT((PolynomialSpace(sites, degree).fit(values) - coefficients).norm(), 1e-12);
    EXPECT_LT(values.norm(), 1e-12);
  }
}

TEST(GlobalPolynomial, ALineAPlaneAndASphereAreToldFromTheRest) {
  Sites line, plane, sphere = test::randomSites(50);
  for (int i = 0; i < 20; ++i) line.push_back({0.1 * i - 1, 0.05 * i, 0.02 * i});
  for (int i = 0; i < 50; ++i) plane.push_back({0.2 * (i % 7), 0.3 * (i / 7), 0.25});
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 p = glm::normalize(sphere[std::size_t(i)]);
    sphere.x[std::size_t(i)] = p.x, sphere.y[std::size_t(i)] = p.y, sphere.z[std::size_t(i)] = p.z;
  }
  EXPECT_TRUE(PolynomialSpace(line, 0).isComplete());
  EXPECT_FALSE(PolynomialSpace(line, 1).isComplete());
  EXPECT_EQ(PolynomialSpace(line, 1).rank(), 2);
  EXPECT_FALSE(PolynomialSpace(plane, 1).isComplete());
  EXPECT_TRUE(PolynomialSpace(sphere, 1).isComplete());
  EXPECT_EQ(PolynomialSpace(sphere, 2).rank(), 9);
  EXPECT_TRUE(PolynomialSpace(test::randomSites(50), 2).isComplete());
}

}  // namespace
}  // namespace sonoskin
