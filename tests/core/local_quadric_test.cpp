#include "core/rbf/compact/local_quadric.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

// Samples that own their arrays.
struct Cloud {
  std::vector<float> u, v, w, r, d;
  void add(double x, double y, double z, double influence = 1) {
    u.push_back(float(x)), v.push_back(float(y)), w.push_back(float(z));
    r.push_back(float(std::sqrt(x * x + y * y + z * z)));
    d.push_back(float(influence));
  }
  LocalSamples samples() const { return {u.data(), v.data(), w.data(), r.data(), d.data(), u.size()}; }
};

Cloud cubicPatch() {
  Cloud cloud;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      cloud.add(x, y, 0.02 * x * x - 0.01 * x * y + 0.03 * y * y + 0.05 * x + 0.001 * x * x * x);
  return cloud;
}

TEST(LocalQuadric, FitsTheReferencePatch) {
  const LocalFit fit = fitQuadric(cubicPatch().samples(), 4);
  EXPECT_NEAR(fit.quadric.A, 0.0199677088, 1e-7);
  EXPECT_NEAR(fit.quadric.B, -0.0049986842, 1e-7);
  EXPECT_NEAR(fit.quadric.C, 0.0300004070, 1e-7);
  EXPECT_NEAR(fit.quadric.D, 0.0530358421, 1e-7);
  EXPECT_NEAR(fit.quadric.E, 6.670e-7, 1e-7);
  EXPECT_NEAR(fit.quadric.F, 2.697e-5, 1e-6);
  EXPECT_NEAR(std::sqrt(fit.meanSquare), 0.0022790004, 1e-8);
}

TEST(LocalQuadric, EqualsADenseLeastSquaresSolution) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Cloud cloud;
  for (int i = 0; i < 60; ++i)
    cloud.add(2 * uniform(random), 2 * uniform(random), 0.3 * uniform(random), 1.2 + uniform(random));
  const double sigma = 2.3;
  Eigen::MatrixXd V(60, 6);
  Eigen::VectorXd rhs(60);
  for (int i = 0; i < 60; ++i) {
    const auto j = std::size_t(i);
    const double u = double(cloud.u[j]), v = double(cloud.v[j]);
    const double root = std::sqrt(double(cloud.d[j]) * double(wendland(float(double(cloud.r[j]) / sigma))));
    V.row(i) << u * u, 2 * u * v, v * v, u, v, 1;
    V.row(i) *= root;
    rhs[i] = root * double(cloud.w[j]);
  }
  const Eigen::VectorXd a = V.colPivHouseholderQr().solve(rhs);
  const LocalQuadric q = fitQuadric(cloud.samples(), sigma).quadric;
  const double found[6] = {q.A, q.B, q.C, q.D, q.E, q.F};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(found[i], a[i], 2e-5) << i;
}

TEST(LocalQuadric, ReproducesAQuadricExactly) {
  Cloud cloud;
  const LocalQuadric truth{0.02, -0.03, 0.05, 0.1, -0.2, 0.3};
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y)
      cloud.add(
          x, y,
          truth.A * x * x + 2 * truth.B * x * y + truth.C * y * y + truth.D * x + truth.E * y + truth.F);
  const LocalFit fit = fitQuadric(cloud.samples(), 6);
  EXPECT_NEAR(fit.quadric.A, truth.A, 1e-6);
  EXPECT_NEAR(fit.quadric.B, truth.B, 1e-6);
  EXPECT_NEAR(fit.quadric.F, truth.F, 1e-5);
  EXPECT_LT(std::sqrt(fit.meanSquare), 1e-5);
}

// The thesis' program halves the mixed term in |∇g|: the same quadric, another residual.
TEST(LocalQuadric, ThePrintedSlopeChangesTheResidualAlone) {
  std::vector<float> u, v, w, r, d;
  for (int y = -4; y <= 4; ++y)
    for (int x = -4; x <= 4; ++x) {
      u.push_back(float(x)), v.push_back(float(y));
      w.push_back(0.2f * float(x * y) + 0.1f * float((3 * x + 5 * y) % 4));
      r.push_back(std::hypot(float(x), float(y)));
      d.push_back(1);
    }
  const LocalSamples samples{u.data(), v.data(), w.data(), r.data(), d.data(), u.size()};
  const double sigma = 4.5;
  const LocalFit exact = fitQuadric(samples, sigma), printed = fitQuadric(samples, sigma, SlopeForm::printed);
  const LocalQuadric& q = exact.quadric;
  EXPECT_EQ(q.B, printed.quadric.B);
  double sum = 0, weights = 0;
  for (std::size_t j = 0; j < u.size(); ++j) {
    const double x = double(u[j]), y = double(v[j]), t = double(r[j]) / sigma;
    const double weight = t < 1 ? std::pow(1 - t, 4) * (4 * t + 1) : 0;
    const double g = double(w[j]) - (q.A * x * x + 2 * q.B * x * y + q.C * y * y + q.D * x + q.E * y + q.F);
    const double gu = 2 * q.A * x + q.B * y + q.D, gv = q.B * x + 2 * q.C * y + q.E;
    sum += weight * g * g / (1 + gu * gu + gv * gv);
    weights += weight;
  }
  EXPECT_NEAR(printed.meanSquare, sum / weights, 1e-4 * printed.meanSquare);
  EXPECT_GT(printed.meanSquare, 1.05 * exact.meanSquare);
}

TEST(LocalQuadric, FallsBackToAPlaneAndToAConstant) {
  Cloud line, place;
  for (int i = -10; i <= 10; ++i) line.add(0.1 * i, 0, 0.05 * i + 0.2);
  for (int i = 0; i < 15; ++i) place.add(0.1, 0.2, 0.3);
  const LocalQuadric q = fitQuadric(line.samples(), 2).quadric, p = fitQuadric(place.samples(), 2).quadric;
  for (const double value : {q.A, q.B, q.C, q.D, q.E, q.F}) EXPECT_TRUE(std::isfinite(value));
  EXPECT_EQ(p.A, 0);
  EXPECT_EQ(p.D, 0);
  EXPECT_NEAR(p.F, 0.3, 1e-5);
  Cloud few;
  for (const auto& [x, y] : {std::pair{1., 0.3}, {-0.8, 0.9}, {-0.4, -1.1}, {0.7, -0.6}})
    few.add(x, y, 0.1 * x - 0.2 * y + 0.3);
  const LocalFit plane = fitQuadric(few.samples(), 2);
  EXPECT_EQ(plane.quadric.A, 0);
  EXPECT_EQ(plane.quadric.B, 0);
  EXPECT_EQ(plane.quadric.C, 0);
  EXPECT_NEAR(plane.quadric.D, 0.1, 1e-6);
  EXPECT_NEAR(plane.quadric.E, -0.2, 1e-6);
  EXPECT_NEAR(plane.quadric.F, 0.3, 1e-6);
  EXPECT_LT(plane.meanSquare, 1e-10);
}

TEST(LocalQuadric, OfNothingWithinTheSupportIsZero) {
  Cloud far;
  for (int i = 0; i < 9; ++i) far.add(3 + 0.1 * i, 0.2 * i, 1);
  const LocalFit fit = fitQuadric(far.samples(), 2);
  EXPECT_EQ(fit.quadric.F, 0);
  EXPECT_EQ(fit.meanSquare, 0);
}

// Derived noise law: white noise of RMS s leaves a mean square of s² (1 - 11.40/n) with n points in the
// support.
TEST(LocalQuadric, LeavesTheKnownShareOfWhiteNoise) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, 0.01);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double mean = 0;
  const int trials = 3000, n = 100;
  for (int t = 0; t < trials; ++t) {
    Cloud cloud;
    while (cloud.u.size() < n) {
      const double x = uniform(random), y = uniform(random);
      if (x * x + y * y < 1) cloud.add(x, y, noise(random));
    }
    mean += fitQuadric(cloud.samples(), 1).meanSquare / trials;
  }
  EXPECT_NEAR(mean, 1e-4 * (1 - 11.40 / n), 0.02 * 1e-4);
}

TEST(LocalQuadric, FramesAreOrthonormalForEveryDirection) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<glm::vec3> directions{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {-1, 0, 0}};
  for (int i = 0; i < 1000; ++i)
    directions.push_back(glm::normalize(glm::vec3(normal(random), normal(random), normal(random))));
  for (const glm::vec3& n : directions) {
    const Frame f = frameAround(n);
    EXPECT_NEAR(glm::determinant(glm::mat3(f.u, f.v, f.normal)), 1, 1e-5f);
    EXPECT_NEAR(glm::dot(f.u, f.v), 0, 1e-6f);
    EXPECT_NEAR(glm::dot(f.u, n), 0, 1e-6f);
    EXPECT_NEAR(glm::length(f.u), 1, 1e-6f);
  }
}

TEST(LocalQuadric, TheGlobalFormIsTheSameFunction) {
  const LocalQuadric q{0.02, -0.03, 0.05, 0.1, -0.2, 0.3};
  const Frame frame = frameAround(glm::normalize(glm::vec3(1, -2, 0.5f)));
  const GlobalQuadric g = toGlobal(q, frame);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-2, 2);
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 x(uniform(random), uniform(random), uniform(random));
    const double u = double(glm::dot(x, frame.u)), v = double(glm::dot(x, frame.v)),
                 w = double(glm::dot(x, frame.normal));
    EXPECT_NEAR(double(g.value(x.x, x.y, x.z)),
                w - (q.A * u * u + 2 * q.B * u * v + q.C * v * v + q.D * u + q.E * v + q.F), 1e-5);
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 a = x, b = x;
      a[axis] -= 0.01f, b[axis] += 0.01f;
      EXPECT_NEAR(g.gradient(x.x, x.y, x.z)[axis], (g.value(b.x, b.y, b.z) - g.value(a.x, a.y, a.z)) / 0.02f,
                  2e-4f);
    }
  }
}

}  // namespace
}  // namespace sonoskin
