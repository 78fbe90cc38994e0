#include "core/mesh/components.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/mesh/iso/marching_cubes.h"

namespace sonoskin {
namespace {

Mesh sphere(const glm::dvec3& centre, double radius) {
  Geometry g;
  g.dims = glm::ivec3(40);
  g.spacing = glm::dvec3(radius / 16);
  g.origin = centre - 19.5 * g.spacing;
  Volume<float> field(g);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        field.at(i, j, k) = float(glm::length(g.toWorld({i, j, k}) - centre) - radius);
  Mesh mesh = marchingCubes(field, 0);
  computeNormals(mesh);
  return mesh;
}

// Two triangles across the axis y at a depth, `half` mm to each side: far larger than a beam of the depth buffer.
Mesh wall(float depth, float half) {
  Mesh mesh;
  mesh.positions = {{-half, depth, -half}, {half, depth, -half}, {half, depth, half}, {-half, depth, half}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.normals.assign(4, {0, -1, 0});
  return mesh;
}

Mesh join(const std::vector<Mesh>& meshes) {
  Mesh all;
  for (const Mesh& m : meshes) {
    const auto base = std::uint32_t(all.positions.size());
    all.positions.insert(all.positions.end(), m.positions.begin(), m.positions.end());
    all.normals.insert(all.normals.end(), m.normals.begin(), m.normals.end());
    for (const Triangle& t : m.triangles) all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return all;
}

std::size_t bestInView(const std::vector<Mesh>& pieces, const Beam& beam, const glm::dvec3& middle) {
  const std::vector<double> shares = viewShares(pieces, beam, middle);
  const auto best = std::max_element(shares.begin(), shares.end());
  EXPECT_EQ(*best, 1);
  return std::size_t(best - shares.begin());
}

TEST(Components, SplitsByAreaAndKeepsAttributes) {
  Mesh all = join({sphere({0, 0, 0}, 3), wall(50, 40), sphere({20, 0, 0}, 5)});
  all.positions.push_back({9, 9, 9});  // a vertex without a triangle belongs to no piece
  all.normals.push_back({0, 0, 1});
  for (std::size_t v = 0; v < all.positions.size(); ++v) all.visibility.push_back(all.positions[v].x);
  all.measured = all.visibility;
  for (const glm::vec3& p : all.positions) all.labels.push_back(std::uint8_t(p.x + 100));
  const std::vector<Mesh> pieces = splitPieces(all);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_NEAR(surfaceArea(pieces[0]), 6400, 1e-3);
  EXPECT_NEAR(surfaceArea(pieces[1]), 4 * M_PI * 25, 2);
  EXPECT_NEAR(surfaceArea(pieces[2]), 4 * M_PI * 9, 1);
  for (const Mesh& p : pieces) {
    ASSERT_EQ(p.normals.size(), p.positions.size());
    ASSERT_EQ(p.visibility.size(), p.positions.size());
    ASSERT_EQ(p.measured, p.visibility);
    for (std::size_t v = 0; v < p.positions.size(); ++v) {
      EXPECT_EQ(p.visibility[v], p.positions[v].x);
      EXPECT_EQ(p.labels[v], std::uint8_t(p.positions[v].x + 100));
    }
  }
  for (std::size_t v = 0; v < pieces[1].positions.size(); ++v)
    EXPECT_GT(glm::dot(pieces[1].normals[v], pieces[1].positions[v] - glm::vec3(20, 0, 0)), 4);
  EXPECT_EQ(joinPieces(pieces).labels.size(), joinPieces(pieces).positions.size());
  EXPECT_TRUE(joinPieces({pieces[0], wall(1, 1)}).labels.empty());
  EXPECT_TRUE(splitPieces(Mesh()).empty());
}

TEST(Components, PiecesKeepTheirTextureCoordinates) {
  Mesh all = join({wall(1, 1), wall(2, 4)});
  for (int t = 0; t < 4; ++t)
    all.cornerUvs.push_back({glm::vec2(float(t)), glm::vec2(float(t)), glm::vec2(float(t))});
  const std::vector<Mesh> pieces = splitPieces(all);
  ASSERT_EQ(pieces[0].cornerUvs.size(), 2u);
  EXPECT_EQ(pieces[0].cornerUvs[1][0].x, 3);
  EXPECT_EQ(joinPieces(pieces).cornerUvs.size(), 4u);
  EXPECT_TRUE(joinPieces({pieces[0], wall(1, 1)}).cornerUvs.empty());
}

TEST(Components, FindsThePieceNearestToAPoint) {
  const std::vector<Mesh> pieces =
      splitPieces(join({sphere({0, 0, 0}, 3), wall(50, 40), sphere({20, 0, 0}, 5)}));
  EXPECT_EQ(pieceNearest(pieces, {13, 48, 7}), 0u);  // far from the wall's corners, near its inside
  EXPECT_EQ(pieceNearest(pieces, {19, 0, 1}), 1u);
  EXPECT_EQ(pieceNearest(pieces, {2, 0, 0}), 2u);
  EXPECT_THROW(pieceNearest({}, {0, 0, 0}), Error);
}

TEST(Components, TheProbeSeesASphereBeforeALargerWall) {
  for (const bool isSector : {false, true}) {
    Beam beam;
    if (isSector) beam.apex = glm::dvec3(0, -20, 0);
    const std::vector<Mesh> pieces = splitPieces(join({sphere({3, 60, -2}, 30), wall(130, 60)}));
    ASSERT_GT(surfaceArea(pieces[0]), surfaceArea(pieces[1]));
    EXPECT_EQ(surfaceArea(pieces[0]), surfaceArea(wall(130, 60)));
    EXPECT_EQ(bestInView(pieces, beam, {0, 60, 0}), 1u) << isSector;
  }
}

TEST(Components, TheProbeSeesTheOuterShellAndNotASpeckInFront) {
  Beam beam;
  beam.apex = glm::dvec3(0, -20, 0);
  const std::vector<Mesh> pieces =
      splitPieces(join({sphere({0, 60, 0}, 20), sphere({0, 60, 0}, 30), sphere({0, 10, 0}, 2)}));
  EXPECT_EQ(bestInView(pieces, beam, {0, 60, 0}), 0u);
  EXPECT_NEAR(surfaceArea(pieces[0]), 4 * M_PI * 900, 60);
}

TEST(Components, TheMiddleBeamDecidesBetweenEqualPieces) {
  Beam beam;  // parallel along y
  const std::vector<Mesh> pieces = splitPieces(join({sphere({-40, 60, 0}, 20), sphere({40, 60, 0}, 20)}));
  const bool firstIsLeft = pieces[0].positions[0].x < 0;
  EXPECT_EQ(bestInView(pieces, beam, {-35, 60, 0}), firstIsLeft ? 0u : 1u);
  EXPECT_EQ(bestInView(pieces, beam, {35, 60, 0}), firstIsLeft ? 1u : 0u);
  EXPECT_TRUE(viewShares({}, beam, {0, 0, 0}).empty());
}

TEST(Components, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(splitPieces(wall(1, 1), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
