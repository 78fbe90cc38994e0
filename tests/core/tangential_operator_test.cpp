#include "core/classification/tangential_operator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

using test::fill;
using test::grid;
using test::noise;

std::vector<float> applied(const TangentialOperator& k, const std::vector<float>& u) {
  std::vector<float> result(u.size());
  k.forEachRow(u, [&](int j, int slice, const float* ku) {
    std::copy_n(ku, k.geometry().dims.x, &result[k.geometry().index(0, j, slice)]);
  });
  return result;
}

std::vector<float> noiseField(const Geometry& g, std::uint64_t seed) {
  std::vector<float> u(g.voxels());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = float(noise(seed * 1000003 + i));
  return u;
}

double dot(const std::vector<float>& a, const std::vector<float>& b) {
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
  EXPECT_NEAR(dot(u, applied(k, u)), expected, 1e-5 * expected);
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
    k.diagonalRow(p.y, p.z, row.data());
    EXPECT_NEAR(row[std::size_t(p.x)], applied(k, unit)[geometry.index(p.x, p.y, p.z)], 5e-6);
  }
}

TEST_F(TangentialOperatorTest, SameBitsOnAnyNumberOfThreads) {
  const auto u = noiseField(geometry, 4);
  setThreadCount(1);
  const auto one = applied(k, u);
  setThreadCount(3);
  const auto three = applied(k, u);
  setThreadCount(0);
  EXPECT_EQ(one, three);
}

TEST_F(TangentialOperatorTest, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(k.forEachRow(
                   noiseField(geometry, 5), [](int, int, const float*) {}, Progress(sink)),
               Cancelled);
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
