// Surfaces of any size, from a grain to a house: what they cost is counted, not timed.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/mesh/facts/mesh_doubts.h"
#include "core/skin/block_diffusion.h"
#include "core/skin/surface_samples.h"
#include "core/skin/triangle_lattice.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

constexpr double kDiameters[] = {1e-3, 1, 10, 100, 1000, 10'000};  // mm

Mesh ball(double diameter, int level = 4) {
  return test::icosphere(level, float(diameter / 2), glm::vec3(0));
}

// A tube of triangles as long as it is and as narrow as a hair.
Mesh needles(int count, float length) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float angle = 6.2831853f * float(i) / float(count);
    const glm::vec3 n(std::cos(angle), std::sin(angle), 0);
    for (const float z : {0.f, length}) {
      mesh.positions.push_back(10.f * n + glm::vec3(0, 0, z));
      mesh.normals.push_back(n);
    }
    const auto a = std::uint32_t(2 * i), b = std::uint32_t(2 * ((i + 1) % count));
    mesh.triangles.push_back({a, b, a + 1});
    mesh.triangles.push_back({b, b + 1, a + 1});
  }
  return mesh;
}

TEST(ObjectSize, TexelsFollowTheObject) {
  SkinQuality quality;
  quality.texels = 2e5;
  int asAsked = 0;
  for (const double diameter : kDiameters) {
    const auto surface = prepareSkin(std::make_shared<const Mesh>(ball(diameter)), {0, -1, 0}, quality);
    const double area = std::numbers::pi * diameter * diameter;
    const double owned =
        double(std::ranges::count_if(surface->maps.position, [](const glm::vec4& p) { return p.w == 1; }));
    EXPECT_LE(double(surface->maps.position.size()), quality.texels) << diameter;
    EXPECT_GT(owned, 3000) << diameter;
    EXPECT_FALSE(surface->pointBased) << diameter;
    EXPECT_LT(surface->check.overlap, 0.01) << diameter;
    // As the quality has them where that is neither too many nor too few.
    if (area > 4096 * 0.0225 && area < 0.3 * 2e5 * 0.0225) {
      EXPECT_FLOAT_EQ(surface->atlas.texel, 0.15f) << diameter;
      ++asAsked;
    }
  }
  EXPECT_GT(asAsked, 0);
}

// Two objects that are far too large for the texels of a body have the same map, whatever their size.
TEST(ObjectSize, ChartsOfLargeObjectsDoNotDependOnTheSize) {
  SkinQuality quality;
  quality.texels = 5e4;
  const auto one = prepareSkin(std::make_shared<const Mesh>(ball(512)), {0, -1, 0}, quality),
             ten = prepareSkin(std::make_shared<const Mesh>(ball(8192)), {0, -1, 0}, quality);
  EXPECT_EQ(one->atlas.size, ten->atlas.size);
  EXPECT_EQ(one->atlas.chart, ten->atlas.chart);
  EXPECT_NEAR(double(ten->atlas.texel) / double(one->atlas.texel), 16, 1e-3);
}

// Specks of a large object, too many for charts: their blocks are bounded, too.
TEST(ObjectSize, BlocksAreBounded) {
  Mesh specks;
  const Mesh speck = test::icosphere(1, 300, {0, 0, 0});
  for (int i = 0; i < 80; ++i) {
    const auto base = std::uint32_t(specks.positions.size());
    for (const glm::vec3& p : speck.positions)
      specks.positions.push_back(p + 900.f * glm::vec3(i % 9, 0, i / 9));
    for (const Triangle& t : speck.triangles)
      specks.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  SkinQuality quality;
  quality.texels = 2e5;
  const auto surface = prepareSkin(std::make_shared<const Mesh>(specks), {0, -1, 0}, quality);
  EXPECT_TRUE(surface->pointBased);
  EXPECT_LE(double(surface->maps.position.size()), quality.texels);
}

TEST(ObjectSize, PointsAndPlacesAreBounded) {
  constexpr std::size_t kMost = 20'000;
  for (const double diameter : kDiameters) {
    const Mesh mesh = ball(diameter, 3);
    const double spacing = affordableSpacing(mesh, 0.2, kMost);
    EXPECT_LE(sampleSurface(mesh, spacing).size(), kMost) << diameter;
    EXPECT_EQ(spacing == 0.2, diameter < 100) << diameter;
    EXPECT_LE(TriangleLattice(mesh, 0.3, kMost).positions().size(), kMost + mesh.positions.size())
        << diameter;
  }
  // No more than one point for a triangle is asked for, and that is always given.
  const Mesh fine = ball(1e4, 4);
  EXPECT_EQ(sampleSurface(fine, affordableSpacing(fine, 0.2, 100)).size(), fine.triangles.size());
}

TEST(ObjectSize, MemoryOfSpreadLightIsBounded) {
  SkinQuality quality;
  quality.texels = 2e5;
  const std::shared_ptr<const SkinSurface> surface =
      prepareSkin(std::make_shared<const Mesh>(ball(10'000)), {0, -1, 0}, quality);
  BlockDiffusion kept;
  const std::vector<glm::vec4> white(surface->maps.position.size(), glm::vec4(1));
  const std::vector<glm::vec4> map =
      diffuseInBlocks(surface, literatureSkin(), {white}, sumWeights(literatureSkin()), kept);
  EXPECT_EQ(map.size(), white.size());
  EXPECT_LT(kept.bytes(), 100'000'000u);
}

// Loose triangles that fill a volume have thousands of clusters within reach of each place: it is asked for fewer places.
TEST(ObjectSize, CloudsOfTrianglesAreAskedAtFewPlaces) {
  Mesh cloud;
  std::uint32_t state = 1;
  const auto random = [&state] { return float(state = state * 1664525u + 1013904223u) / 4294967296.f; };
  for (std::uint32_t i = 0; i < 30'000; ++i) {
    const glm::vec3 middle(20 * random(), 20 * random(), 20 * random());
    for (int corner = 0; corner < 3; ++corner)
      cloud.positions.push_back(middle + 2.f * glm::vec3(random(), random(), random()));
    cloud.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  SkinQuality quality;
  quality.texels = 2e5;
  const std::shared_ptr<const SkinSurface> surface =
      prepareSkin(std::make_shared<const Mesh>(std::move(cloud)), {0, -1, 0}, quality);
  const SurfaceSamples samples = sampleSurface(*surface->mesh, 0.2);
  const PointDiffusion points({samples.positions, samples.normals, samples.areas}, literatureSkin());
  const double meanNeighbours = points.meanNeighbours(PointDiffusion::kLevels);
  EXPECT_GT(meanNeighbours, 2000);
  BlockDiffusion kept;
  const std::vector<glm::vec4> white(surface->maps.position.size(), glm::vec4(1));
  levelsInBlocks(surface, literatureSkin(), {white}, kept);
  EXPECT_LT(double(kept.placesAsked(PointDiffusion::kLevels)) * meanNeighbours, 1.5e9);
  const SurfaceSamples smooth = sampleSurface(ball(20), 0.2);
  const PointDiffusion few({smooth.positions, smooth.normals, smooth.areas}, literatureSkin());
  for (int level = 1; level <= PointDiffusion::kLevels; ++level)
    EXPECT_LT(few.meanNeighbours(level), 400) << level;
}

// Where points are too far apart for a Gaussian the light stays as it is: the change from one to the other is no step
// that can be seen in texels as large as the points' distance.
TEST(ObjectSize, LightOfLargeObjectsTendsToWhatFalls) {
  const auto differenceOf = [](double diameter) {
    SkinQuality quality;
    quality.texels = 5e4;
    const std::shared_ptr<const SkinSurface> surface =
        prepareSkin(std::make_shared<const Mesh>(ball(diameter)), {0, -1, 0}, quality);
    std::vector<glm::vec4> light;
    for (std::size_t t = 0; t < surface->maps.position.size(); ++t)
      light.push_back(surface->maps.position[t].w == 0
                          ? glm::vec4(0)
                          : glm::vec4(glm::vec3(std::max(0.f, surface->maps.normal[t].x)), 1));
    BlockDiffusion kept;
    double sum = 0, count = 0;
    for (const auto& level : levelsInBlocks(surface, literatureSkin(), {light}, kept))
      for (std::size_t t = 0; t < light.size(); ++t)
        if (surface->maps.position[t].w == 1) {
          sum += std::abs(double(level[t].x - light[t].x));
          ++count;
        }
    return sum / count;
  };
  double before = differenceOf(20);
  EXPECT_GT(before, 0.005);
  for (const double diameter : {100.0, 1000.0, 10'000.0}) {
    const double here = differenceOf(diameter);
    EXPECT_LE(here, before + 1e-6) << diameter;
    before = here;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(ObjectSize, NeedlesAreCutAlongTheirLengthAlone) {
  const Mesh mesh = needles(1500, 100);
  const SurfaceSamples samples = sampleSurface(mesh, 0.2);
  EXPECT_LT(samples.size(), 1500u * 2 * 260);  // 250 of 0.4 mm each; squares as long would be 62,500
  EXPECT_NEAR(std::accumulate(samples.areas.begin(), samples.areas.end(), 0.0), surfaceArea(mesh),
              1e-3 * surfaceArea(mesh));
  double moment = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    moment += double(samples.areas[i]) * double(samples.positions[i].z);
  EXPECT_NEAR(moment, 50 * surfaceArea(mesh), 1e-3 * 50 * surfaceArea(mesh));

  const TriangleLattice lattice(mesh, 0.3);
  EXPECT_LT(lattice.positions().size(), 1500u * 2 * 700);
  const auto f = [](const glm::vec3& p) { return 2 * p.x - 3 * p.y + 0.1f * p.z; };
  std::vector<float> values;
  for (const glm::vec3& p : lattice.positions()) values.push_back(f(p));
  for (const std::uint32_t t : {0u, 1u, 777u})
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; i + j <= 20; ++j) {
        const glm::vec3 w(float(20 - i - j) / 20, float(i) / 20, float(j) / 20);
        const Triangle& c = mesh.triangles[t];
        const glm::vec3 p =
            w.x * mesh.positions[c[0]] + w.y * mesh.positions[c[1]] + w.z * mesh.positions[c[2]];
        ASSERT_NEAR(lattice.value(values, c, t, w), f(p), 1e-3) << t << " " << i << " " << j;
      }
}

// A factor that makes a surface larger than any reader lets in is refused as the file would be.
TEST(ObjectSize, ScalingIsNoWayAroundTheLimits) {
  Mesh mesh = ball(100, 1);
  test::expectError([&] { scaleMesh(mesh, 1e6f); }, "check its unit");
}

}  // namespace
}  // namespace sonoskin
