#include "core/classification/tangential_operator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/applied.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

using test::applied;
using test::fill;
using test::grid;
using test::noise;

std::vector<float> noiseField(const Geometry& g, std::uint64_t seed) {
  std::vector<float> u(g.voxels());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = float(noise(seed * 1000003 + i));
  return u;
}

template <class A, class B>
double dot(const A& a, const B& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * double(b[i]);
  return sum;
}

// The energy beta sum |grad u x q|^2 over cells, straight from its definition, in double.
double energy(const Directions& d, const std::vector<float>& u, double beta) {
  const Geometry& g = d.geometry;
  const glm::dvec3 scale = glm::dvec3(g.axisScale());
  double sum = 0;
  for (int k = 0; k + 1 < g.dims.z; ++k)
    for (int j = 0; j + 1 < g.dims.y; ++j)
      for (int i = 0; i + 1 < g.dims.x; ++i) {
        glm::dvec3 gradient(0);
        for (int corner = 0; corner < 8; ++corner) {
          const glm::ivec3 c(corner & 1, corner >> 1 & 1, corner >> 2);
          gradient +=
              0.25 * scale * (2.0 * glm::dvec3(c) - 1.0) * double(u[g.index(i + c.x, j + c.y, k + c.z)]);
        }
        const std::size_t cell = g.index(i, j, k);
        const glm::dvec3 q = glm::dvec3(d.x[cell], d.y[cell], d.z[cell]) / 127.0;
        const glm::dvec3 turned = glm::cross(gradient, q);
        sum += beta * glm::dot(turned, turned);
      }
  return sum;
}

// The gradient between eight voxels over its length, which fades where that is near kappa; none beyond the last voxels.
TEST(CellDirections, AreTheNormalisedGradient) {
  const Geometry g = grid({9, 8, 7}, {1, 2, 1.5});
  std::uint64_t n = 0;
  const auto volume = fill(g, [&](glm::dvec3) { return 0.2 * noise(n++); });
  const double kappa = 0.05;
  const Directions d = cellDirections(volume, kappa);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        glm::dvec3 gradient(0);
        const bool isCell = i + 1 < g.dims.x && j + 1 < g.dims.y && k + 1 < g.dims.z;
        for (int corner = 0; isCell && corner < 8; ++corner) {
          const glm::ivec3 c(corner & 1, corner >> 1 & 1, corner >> 2);
          gradient += 0.25 * glm::dvec3(g.axisScale()) * (2.0 * glm::dvec3(c) - 1.0) *
                      double(volume.at(i + c.x, j + c.y, k + c.z));
        }
        const glm::dvec3 q = 127.0 * gradient / std::sqrt(glm::dot(gradient, gradient) + kappa * kappa);
        const std::size_t cell = g.index(i, j, k);
        const glm::dvec3 found(d.x[cell], d.y[cell], d.z[cell]);
        for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(found[axis], q[axis], 0.501) << cell;
      }
}

class TangentialOperatorTest : public ::testing::Test {
 protected:
  const Geometry geometry = grid({17, 14, 11}, {0.3, 0.3, 0.9});
  const Volume<float> volume = test::speckledSphere(geometry, {2.4, 2.0, 4.5}, 1.5, 0.5);
  const std::shared_ptr<const Directions> directions =
      std::make_shared<const Directions>(cellDirections(volume, 0.02));
  const TangentialOperator k{directions, 3.5};
};

TEST_F(TangentialOperatorTest, QuadraticFormIsTheEnergy) {
  const auto u = noiseField(geometry, 1);
  const double expected = energy(*directions, u, 3.5);
  EXPECT_GT(expected, 1);
  EXPECT_NEAR(dot(u, applied(k, u)), expected, 1e-7 * expected);  // K u is in single precision
}

// Rounding of single values averages out in a larger volume; the constants are those that single precision holds exactly.
TEST(TangentialOperator, EnergyHoldsToEightDigits) {
  const double beta = 127.0 * 127.0 * 16 / 65536;
  const Geometry g = grid({64, 48, 40}, {0.5, 0.5, 1});
  const auto volume = test::speckledSphere(g, {16, 12, 20}, 8, 0.5);
  const auto directions = std::make_shared<const Directions>(cellDirections(volume, 0.02));
  const auto u = noiseField(g, 8);
  const double expected = energy(*directions, u, beta);
  EXPECT_NEAR(dot(u, applied(TangentialOperator(directions, beta), u)), expected, 1e-8 * expected);
}

TEST_F(TangentialOperatorTest, IsSymmetric) {
  const auto u = noiseField(geometry, 2), v = noiseField(geometry, 3);
  EXPECT_NEAR(dot(v, applied(k, u)), dot(u, applied(k, v)), 1e-4);
}

TEST_F(TangentialOperatorTest, AnnihilatesConstants) {
  for (const float value : applied(k, std::vector<float>(geometry.voxels(), 0.7f)))
    EXPECT_NEAR(value, 0, 1e-6);
}

TEST_F(TangentialOperatorTest, DiagonalIsWhatAProbeFinds) {
  std::vector<float> row(std::size_t(geometry.dims.x));
  for (const glm::ivec3 p :
       {glm::ivec3(0, 0, 0), glm::ivec3(16, 13, 10), glm::ivec3(7, 6, 5), glm::ivec3(8, 0, 4)}) {
    std::vector<float> unit(geometry.voxels(), 0.0f);
    unit[geometry.index(p.x, p.y, p.z)] = 1;
    std::fill(row.begin(), row.end(), 0.0f);
    k.addDiagonalRow(p.y, p.z, row.data());
    EXPECT_NEAR(row[std::size_t(p.x)], applied(k, unit)[geometry.index(p.x, p.y, p.z)], 5e-6);
  }
}

// A volume of several tiles along each axis, the last ones cut: tiles must fit together. The twin gathers cell by cell.
TEST(TangentialOperator, TilesFitTogether) {
  const Geometry g = grid(2 * kTileSize + glm::ivec3(5, 1, 3), {0.3, 0.3, 0.6});
  const auto volume = test::speckledSphere(g, 0.15 * glm::dvec3(g.dims), 4, 0.5);
  const auto directions = std::make_shared<const Directions>(cellDirections(volume, 0.02));
  const TangentialOperator k(directions, 2);
  const auto u = noiseField(g, 7);
  std::vector<double> expected(g.voxels(), 0.0);
  const glm::dvec3 scale(g.axisScale());
  for (int c = 0; c + 1 < g.dims.z; ++c)
    for (int b = 0; b + 1 < g.dims.y; ++b)
      for (int a = 0; a + 1 < g.dims.x; ++a) {
        const std::size_t cell = g.index(a, b, c);
        const glm::dvec3 q =
            glm::dvec3(directions->x[cell], directions->y[cell], directions->z[cell]) / 127.0;
        std::array<std::pair<std::size_t, glm::dvec3>, 8> corners;
        glm::dvec3 gradient(0);
        for (int n = 0; n < 8; ++n) {
          const glm::ivec3 up(n & 1, n >> 1 & 1, n >> 2);
          corners[std::size_t(n)] = {g.index(a + up.x, b + up.y, c + up.z),
                                     0.25 * scale * (2.0 * glm::dvec3(up) - 1.0)};
          gradient += corners[std::size_t(n)].second * double(u[corners[std::size_t(n)].first]);
        }
        const glm::dvec3 flux = 2.0 * (glm::dot(q, q) * gradient - q * glm::dot(q, gradient));
        for (const auto& [voxel, e] : corners) expected[voxel] += glm::dot(e, flux);
      }
  const auto ku = applied(k, u);
  for (std::size_t v = 0; v < ku.size(); ++v) ASSERT_NEAR(ku[v], expected[v], 2e-5) << "voxel " << v;
}

TEST(TangentialOperator, KnowsItsLargestEigenvalue) {
  const auto of = [](glm::dvec3 spacing) {
    const Geometry g = grid({8, 8, 8}, spacing);
    const auto directions = std::make_shared<const Directions>(cellDirections(Volume<float>(g, 0.0f), 0.02));
    return TangentialOperator(directions, 1).largestEigenvalue();
  };
  EXPECT_NEAR(of({1, 1, 1}), 4, 1e-6);
  EXPECT_NEAR(of({1, 1, 3}), 7.2, 0.01);  // n along x: S D S = diag(0, 1, 1/9), 8 / (1 + 1/9)
}

// A wave whose gradient is everywhere along one direction is not smoothed across itself.
TEST(TangentialOperator, PlaneWavesDoNotLeak) {
  const Geometry g = grid({16, 16, 16});
  for (const glm::dvec3 along : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1),
                                 glm::normalize(glm::dvec3(1, 1, 0)), glm::normalize(glm::dvec3(1, -1, 1))}) {
    const auto wave = fill(g, [&](glm::dvec3 p) { return 0.5 + 0.4 * std::sin(0.7 * glm::dot(along, p)); });
    auto directions = std::make_shared<Directions>(cellDirections(wave, 1e-3));
    const TangentialOperator k(directions, 10);
    for (const float value : applied(k, wave.data)) EXPECT_NEAR(value, 0, 2e-5);
  }
}

TEST(TangentialOperator, SmoothsAlongThePlane) {
  const Geometry g = grid({16, 16, 16});
  const auto layers = fill(g, [](glm::dvec3 p) { return 0.05 * p.x; });  // normals along i
  const TangentialOperator k(std::make_shared<const Directions>(cellDirections(layers, 1e-3)), 1);
  const auto ripple = fill(g, [](glm::dvec3 p) { return std::sin(0.5 * p.y); });
  const auto across = fill(g, [](glm::dvec3 p) { return std::sin(0.5 * p.x); });
  EXPECT_GT(dot(ripple.data, applied(k, ripple.data)), 100);
  EXPECT_NEAR(dot(across.data, applied(k, across.data)), 0, 1e-2);
}

}  // namespace
}  // namespace sonoskin
