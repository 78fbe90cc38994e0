#include "core/skin/skin_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/log.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

std::shared_ptr<const Mesh> ball(int level) {
  return std::make_shared<const Mesh>(test::icosphere(level, 30, {1, 2, 3}));
}

SkinQuality coarse() {
  SkinQuality quality;
  quality.texel = 0.6;
  return quality;
}

void expectFits(const SkinSurface& surface) {
  EXPECT_EQ(surface.atlas.corners.size(), surface.mesh->triangles.size());
  EXPECT_EQ(surface.vertices.triangles.size(), surface.mesh->triangles.size());
  EXPECT_EQ(surface.mesh->normals.size(), surface.mesh->positions.size());
  EXPECT_EQ(surface.maps.size, surface.atlas.size);
  EXPECT_EQ(surface.maps.stretch.size(), surface.maps.position.size());
}

TEST(SkinSurface, OfASphereHasAnAtlasAndAllMaps) {
  const std::shared_ptr<const Mesh> mesh = ball(4);
  const auto surface = prepareSkin(mesh, {0, -1, 0}, coarse());
  expectFits(*surface);
  EXPECT_EQ(surface->mesh, mesh) << "What need not change is not copied.";
  EXPECT_TRUE(surface->check.good());
  EXPECT_FALSE(surface->pointBased);
  EXPECT_FLOAT_EQ(surface->atlas.texel, 0.6f);
  int owned = 0;
  for (std::size_t i = 0; i < surface->maps.position.size(); ++i)
    if (surface->maps.position[i].w == 1) {
      ++owned;
      EXPECT_GT(surface->maps.occlusion[i].w, 0.9f);
      EXPECT_NEAR(surface->maps.normal[i].w, 1 / 30., 0.005);
    }
  EXPECT_GT(owned, 10000);
}

TEST(SkinSurface, IsReducedWhereTheQualityAsksForIt) {
  SkinQuality quality = coarse();
  quality.triangles = 1000;
  const auto surface = prepareSkin(ball(4), {0, -1, 0}, quality);
  expectFits(*surface);
  EXPECT_LT(surface->mesh->triangles.size(), 1300u);
  EXPECT_EQ(lightQuality().triangles, 100000);
  EXPECT_GT(lightQuality().texel, fullQuality().texel);
}

TEST(SkinSurface, IsPointBasedWhereNoAtlasIsGood) {
  // More loose pieces than an atlas may have charts.
  Mesh specks;
  const Mesh speck = test::icosphere(1, 2, {0, 0, 0});
  for (int i = 0; i < 80; ++i) {
    const auto base = std::uint32_t(specks.positions.size());
    for (const glm::vec3& p : speck.positions)
      specks.positions.push_back(p + glm::vec3(6 * (i % 9), 0, 6 * (i / 9)));
    for (const Triangle& t : speck.triangles)
      specks.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  const auto surface = prepareSkin(std::make_shared<const Mesh>(specks), {0, -1, 0}, coarse());
  expectFits(*surface);
  EXPECT_FALSE(surface->check.good());
  EXPECT_TRUE(surface->pointBased);
  EXPECT_EQ(surface->atlas.charts, int(specks.triangles.size()));
  EXPECT_TRUE(surface->atlas.skirts.empty());
}

TEST(SkinSurface, HasTheMeshsOwnCoordinatesWhereThatIsAskedForAndTheyAreGood) {
  Mesh square;
  square.positions = {{0, 0, 0}, {20, 0, 0}, {20, 0, 20}, {0, 0, 20}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  square.cornerUvs = {{{{0, 0}, {0, 1}, {1, 1}}},
                      {{{0, 0}, {1, 1}, {1, 0}}}};  // turned over, unlike an atlas of ours
  computeNormals(square);
  SkinQuality quality = coarse();
  const auto isOwn = [&] {
    const auto surface = prepareSkin(std::make_shared<const Mesh>(square), {0, -1, 0}, quality);
    expectFits(*surface);
    return surface->atlas.corners[0][1].x == surface->atlas.corners[0][0].x;
  };
  std::string said;
  setLogListener([&said](LogLevel, const std::string& sentence) { said += sentence; });
  EXPECT_FALSE(isOwn());
  quality.ownCoordinates = true;
  EXPECT_TRUE(isOwn());
  EXPECT_EQ(said, "");
  square.cornerUvs[1] = {{{0, 0}, {0, 1}, {1, 1}}};  // both at one place
  EXPECT_FALSE(isOwn());
  EXPECT_NE(said.find("on top of each other"), std::string::npos) << said;
  setLogListener({});
}

TEST(SkinSurface, OfNothingIsAnErrorAndItCanBeCancelled) {
  EXPECT_THROW(prepareSkin(nullptr, {0, -1, 0}, {}), Error);
  EXPECT_THROW(prepareSkin(std::make_shared<const Mesh>(), {0, -1, 0}, {}), Error);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(prepareSkin(ball(3), {0, -1, 0}, {}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
