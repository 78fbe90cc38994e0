#include "core/volume/lasso.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/volumes.h"

namespace sonoskin {
namespace {

Volume<std::uint8_t> emptyMask(const glm::ivec3& dims = {30, 24, 16}) {
  Geometry geometry = test::turnedGeometry();
  geometry.dims = dims;
  return Volume<std::uint8_t>(geometry);
}

// A picture whose pixels are voxels, with the centre of each in its middle: x is i, y is j, and depth is k.
glm::dmat4 indexPicture(const Geometry& g) {
  glm::dmat4 toWorld(1);
  for (int axis = 0; axis < 3; ++axis) toWorld[axis] = glm::dvec4(g.direction[axis] * g.spacing[axis], 0);
  toWorld[3] = glm::dvec4(g.origin, 1);
  return glm::translate(glm::dmat4(1), glm::dvec3(0.5, 0.5, 0)) * glm::inverse(toWorld);
}

std::size_t count(const VoxelRuns& runs) {
  std::size_t sum = 0;
  for (const VoxelRun& run : runs) sum += run.count;
  return sum;
}

Lasso square(const Geometry& g) {
  return {.outline = {{4, 5}, {14, 5}, {14, 11}, {4, 11}}, .toPicture = indexPicture(g)};
}

TEST(Lasso, CutsThroughTheWholeDepth) {
  auto mask = emptyMask();
  EXPECT_EQ(count(paint(mask, square(mask.geometry))), 10u * 6 * 16);
  EXPECT_EQ(mask.at(4, 5, 0), 1);
  EXPECT_EQ(mask.at(13, 10, 15), 1);
  EXPECT_EQ(mask.at(14, 10, 15), 0);
  EXPECT_EQ(mask.at(13, 11, 0), 0);
  EXPECT_TRUE(paint(mask, square(mask.geometry)).empty()) << "all of it is marked already";
}

TEST(Lasso, ToADepthOutsideAndBack) {
  auto mask = emptyMask();
  Lasso lasso = square(mask.geometry);
  lasso.from = 3 - 1e-6, lasso.to = 7 + 1e-6;
  EXPECT_EQ(count(paint(mask, lasso)), 10u * 6 * 5);
  lasso.outside = true;
  EXPECT_EQ(count(paint(mask, lasso)), (30u * 24 - 10 * 6) * 5);
  lasso.outside = lasso.mark = false;
  EXPECT_EQ(count(paint(mask, lasso)), 10u * 6 * 5);
  EXPECT_EQ(mask.at(8, 8, 5), 0);
  EXPECT_EQ(mask.at(1, 1, 5), 1);
}

// What an outline goes round counts, once or twice; a figure of eight has two loops.
TEST(Lasso, OutlinesThatCrossThemselves) {
  auto mask = emptyMask();
  Lasso twice = square(mask.geometry);
  const auto once = twice.outline;
  twice.outline.insert(twice.outline.end(), once.begin(), once.end());
  EXPECT_EQ(count(paint(mask, twice)), 10u * 6 * 16);
  mask = emptyMask();
  Lasso eight = square(mask.geometry);
  eight.outline = {{2, 2}, {12, 2}, {2, 12}, {12, 12}};
  paint(mask, eight);
  EXPECT_EQ(mask.at(7, 3, 4), 1);
  EXPECT_EQ(mask.at(7, 10, 4), 1);
  EXPECT_EQ(mask.at(3, 7, 4), 0);
}

TEST(Lasso, OutlinesWithoutAnArea) {
  auto mask = emptyMask();
  Lasso lasso = square(mask.geometry);
  for (const std::vector<glm::dvec2>& outline :
       {std::vector<glm::dvec2>{}, {{3, 3}}, {{3, 3}, {9, 9}}, {{3, 3}, {9, 3}, {5, 3}}}) {
    lasso.outline = outline;
    EXPECT_TRUE(paint(mask, lasso).empty());
  }
  lasso.outline = {{NAN, 3}, {9, 3}, {5, 9}};
  EXPECT_TRUE(paint(mask, lasso).empty());
  lasso.outline = {{-1e300, 3}, {1e300, 3}, {5, 1e300}};
  EXPECT_TRUE(paint(mask, lasso).empty());
}

// How often a circle's outline goes round a place does not need its pixels.
TEST(Lasso, ThroughACameraIsWhatIsSeenInTheCircle) {
  auto mask = emptyMask({40, 40, 40});
  const Geometry& g = mask.geometry;
  const glm::dvec3 middle = g.toWorld({20, 20, 20}),
                   eye = middle + glm::dvec3(9, -7, 4);  // within the volume
  const glm::dmat4 view = glm::lookAt(eye, middle, glm::dvec3(0, 0, 1));
  constexpr double kScale = 200, kRadius = 60;
  Lasso lasso;
  // x w, y w, depth, w
  lasso.toPicture = glm::dmat4(kScale, 0, 0, 0, 0, -kScale, 0, 0, -100, -100, -1, -1, 0, 0, 0, 0) * view;
  for (int n = 0; n < 720; ++n)
    lasso.outline.push_back(glm::dvec2(100) + kRadius * glm::dvec2(std::cos(n * glm::pi<double>() / 360),
                                                                   std::sin(n * glm::pi<double>() / 360)));
  paint(mask, lasso);
  std::size_t inside = 0;
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i) {
        const glm::dvec3 p(view * glm::dvec4(g.toWorld({i, j, k}), 1));
        const double off = p.z < 0 ? kScale * std::hypot(p.x, p.y) / -p.z : 1e9;
        if (std::abs(off - kRadius) < 1) continue;  // the border's pixels
        inside += off < kRadius;
        ASSERT_EQ(mask.at(i, j, k) != 0, off < kRadius) << i << " " << j << " " << k;
      }
  EXPECT_GT(inside, 100u);
}

TEST(Lasso, NearestWithinIsTheFirstThatIsSeen) {
  const Geometry g = emptyMask().geometry;
  Volume<float> volume(g);
  volume.at(8, 8, 6) = 0.5f;
  volume.at(8, 9, 4) = 0.2f;
  volume.at(20, 9, 2) = 0.9f;  // beside the outline
  EXPECT_NEAR(nearestWithin(volume, 0.4, square(g)), 6, 1e-9);
  EXPECT_NEAR(nearestWithin(volume, 0.1, square(g)), 4, 1e-9);
  EXPECT_EQ(nearestWithin(volume, 0.6, square(g)), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace sonoskin
