// Open sky and curvature of every vertex, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/mesh/atlas/atlas_maps.h"
#include "core/mesh/surface_curvature.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// A surface over `columns` x `rows` steps of two parameters in [0, 1].
template <class Shape>
Mesh grid(int columns, int rows, const Shape& shape) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      mesh.positions.push_back(shape(float(i) / float(columns), float(j) / float(rows)));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto a = std::uint32_t(j * (columns + 1) + i), b = a + std::uint32_t(columns) + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  computeNormals(mesh);
  return mesh;
}

TEST(SurfaceTraits, AllOfTheSkyIsOpenOverAPlaneAndASphere) {
  const Mesh plane = grid(20, 20, [](float u, float v) { return glm::vec3(30 * u, 30 * v, 0); });
  for (const glm::vec4& o : measureTraits(plane, 64).occlusion) {
    EXPECT_FLOAT_EQ(o.w, 1);
    EXPECT_GT(o.z, 0.99f);
  }
  const Mesh ball = test::icosphere(4, 25, {5, 0, 0});
  const SurfaceTraits traits = measureTraits(ball, 64);
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    EXPECT_GT(traits.occlusion[i].w, 0.97f);
    EXPECT_GT(glm::dot(glm::vec3(traits.occlusion[i]), ball.normals[i]), 0.98f);
  }
}

TEST(SurfaceTraits, HalfOfTheSkyIsOpenEverywhereInABowlOfAHemisphere) {
  // The opening's form factor is the same at every point of a sphere: its area over that of the sphere that it closes.
  Mesh bowl = test::icosphere(5, 25, {0, 0, 0});
  std::erase_if(bowl.triangles, [&](const Triangle& t) {
    return bowl.positions[t[0]].z + bowl.positions[t[1]].z + bowl.positions[t[2]].z > 0;
  });
  for (Triangle& t : bowl.triangles) std::swap(t[1], t[2]);
  for (glm::vec3& n : bowl.normals) n = -n;
  const SurfaceTraits traits = measureTraits(bowl, 256);
  for (std::size_t i = 0; i < bowl.positions.size(); ++i)
    if (bowl.positions[i].z < -5) {
      EXPECT_NEAR(traits.occlusion[i].w, 0.5, 0.06);
    }
  // At the bottom the open sky is all around the axis.
  for (std::size_t i = 0; i < bowl.positions.size(); ++i)
    if (bowl.positions[i].z < -24.99f) {
      EXPECT_GT(traits.occlusion[i].z, 0.99f);
    }
}

TEST(SurfaceTraits, ClosedSpacesAreDark) {
  Mesh inside = test::icosphere(4, 25, {0, 0, 0});
  for (Triangle& t : inside.triangles) std::swap(t[1], t[2]);
  for (glm::vec3& n : inside.normals) n = -n;
  for (const glm::vec4& o : measureTraits(inside, 64).occlusion) {
    EXPECT_LT(o.w, 0.01f);
    EXPECT_NEAR(glm::length(glm::vec3(o)), 1, 1e-4);
  }
}

TEST(SurfaceTraits, CurvatureOfASphereIsOneOverItsRadius) {
  const Mesh ball = test::icosphere(5, 20, {0, 0, 0});
  for (const float h : meanCurvature(ball, 2)) EXPECT_NEAR(h, 1 / 20., 0.0015);
  Mesh inside = ball;
  for (Triangle& t : inside.triangles) std::swap(t[1], t[2]);
  for (const float h : meanCurvature(inside, 2)) EXPECT_NEAR(h, -1 / 20., 0.0015);
}

TEST(SurfaceTraits, CurvatureOfACylinderIsHalfOfOneOverItsRadiusAndOfAPlaneNone) {
  const Mesh pipe = grid(240, 60, [](float u, float v) {
    const float angle = 2 * std::numbers::pi_v<float> * u;
    return glm::vec3(10 * std::cos(angle), 10 * std::sin(angle), 20 * v);
  });
  const std::vector<float> ofPipe = meanCurvature(pipe, 2);
  for (std::size_t i = 0; i < ofPipe.size(); ++i)
    if (std::abs(pipe.positions[i].x) < 9) {
      EXPECT_NEAR(ofPipe[i], 1 / 20., 0.002);  // its sides touch at x = 10, unjoined
    }
  const Mesh plane = grid(20, 20, [](float u, float v) { return glm::vec3(30 * u, 30 * v, 0); });
  for (const float h : meanCurvature(plane, 2)) EXPECT_NEAR(h, 0, 1e-6);
}

TEST(SurfaceTraits, CurvatureDoesNotDependOnHowFineTheTrianglesAre) {
  const auto bump = [](float u, float v) {
    return glm::vec3(40 * u, 40 * v, 2 * std::cos(12 * u) * std::cos(9 * v));
  };
  const Mesh coarse = grid(60, 60, bump), fine = grid(240, 240, bump);
  const std::vector<float> a = meanCurvature(coarse, 2), b = meanCurvature(fine, 2);
  for (std::size_t j = 8; j <= 52; ++j)
    for (std::size_t i = 8; i <= 52; ++i) EXPECT_NEAR(a[j * 61 + i], b[4 * j * 241 + 4 * i], 0.012);
}

TEST(SurfaceTraits, VerticesWithoutATriangleAndMeshesWithoutNormalsAreFine) {
  Mesh mesh = test::icosphere(2, 10, {0, 0, 0});
  mesh.positions.push_back({0, 0, 0});
  mesh.normals.clear();
  const SurfaceTraits traits = measureTraits(mesh, 8);
  ASSERT_EQ(traits.occlusion.size(), mesh.positions.size());
  ASSERT_EQ(traits.curvature.size(), mesh.positions.size());
  EXPECT_EQ(traits.curvature.back(), 0);
  EXPECT_TRUE(measureTraits({}, 8).occlusion.empty());
}

}  // namespace
}  // namespace sonoskin
