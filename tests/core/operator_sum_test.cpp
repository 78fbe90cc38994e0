#include "core/classification/operator_sum.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/classification/tangential_operator.h"
#include "tests/support/applied.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A second term as somebody might add it: the energy weight * sum (u - u')^2 over neighbours along i.
class AlongRows {
 public:
  AlongRows(const Geometry& geometry, float weight) : geometry_(geometry), weight_(weight) {}

  void apply(const float* u, const Tile& tile, const TileRow& row) const {
    std::vector<float> ku(std::size_t(tile.last.x - tile.first.x));
    for (int k = tile.first.z; k < tile.last.z; ++k)
      for (int j = tile.first.y; j < tile.last.y; ++j) {
        const float* v = u + geometry_.index(0, j, k);
        for (int i = tile.first.x; i < tile.last.x; ++i)
          ku[std::size_t(i - tile.first.x)] =
              weight_ * ((i > 0 ? v[i] - v[i - 1] : 0) + (i + 1 < geometry_.dims.x ? v[i] - v[i + 1] : 0));
        row(j, k, ku.data());
      }
  }
  void addDiagonalRow(int, int, float* out) const {
    for (int i = 0; i < geometry_.dims.x; ++i)
      out[i] += weight_ * (float(i > 0) + float(i + 1 < geometry_.dims.x));
  }
  double largestEigenvalue() const { return 2; }
  const Geometry& geometry() const { return geometry_; }

 private:
  Geometry geometry_;
  float weight_;
};

std::vector<float> noiseField(std::size_t count) {
  std::vector<float> u(count);
  for (std::size_t i = 0; i < count; ++i) u[i] = float(test::noise(17 + i));
  return u;
}

// Several tiles along each axis, the last ones cut.
class OperatorSumTest : public ::testing::Test {
 protected:
  const Geometry geometry = test::grid(kTileSize + glm::ivec3(5, 3, 2), {0.3, 0.3, 0.9});
  const Volume<float> volume = test::speckledSphere(geometry, 0.15 * glm::dvec3(geometry.dims), 3, 0.5);
  const TangentialOperator tangential{std::make_shared<const Directions>(cellDirections(volume, 0.02)), 2};
  const AlongRows rows{geometry, 0.7f};
  const std::vector<float> u = noiseField(geometry.voxels());
};

TEST_F(OperatorSumTest, AppliesTheSumOfItsTerms) {
  const auto first = test::applied(tangential, u), second = test::applied(rows, u);
  const auto both = test::applied(OperatorSum(tangential, rows), u);
  const auto three = test::applied(OperatorSum(rows, tangential, rows), u);
  for (std::size_t v = 0; v < u.size(); ++v) {
    ASSERT_EQ(both[v], first[v] + second[v]);
    ASSERT_NEAR(three[v], first[v] + 2 * second[v], 1e-5);
  }
}

TEST_F(OperatorSumTest, OneTermAloneIsItself) {
  EXPECT_EQ(test::applied(OperatorSum(tangential), u), test::applied(tangential, u));
}

TEST_F(OperatorSumTest, AddsDiagonals) {
  const auto width = std::size_t(geometry.dims.x);
  std::vector<float> sum(width, 5.0f), separate(width, 0.0f);  // what was there does not count
  OperatorSum(tangential, rows).diagonalRow(4, 3, sum.data());
  tangential.addDiagonalRow(4, 3, separate.data());
  rows.addDiagonalRow(4, 3, separate.data());
  EXPECT_EQ(sum, separate);
}

TEST_F(OperatorSumTest, TakesTheLargestBound) {
  EXPECT_EQ(OperatorSum(rows).largestEigenvalue(), 2);
  EXPECT_EQ(OperatorSum(rows, tangential).largestEigenvalue(), tangential.largestEigenvalue());
  EXPECT_EQ(OperatorSum(tangential, rows).largestEigenvalue(), tangential.largestEigenvalue());
}

}  // namespace
}  // namespace sonoskin
