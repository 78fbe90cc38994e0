#include "core/face/face_space.h"

#include <gtest/gtest.h>

#include "core/phantom/random_field.h"

namespace sonoskin {
namespace {

using glm::vec3;

// A plate at z = 0 that looks up, 60 mm wide.
SurfacePoints plate() {
  SurfacePoints points;
  for (float y = -30; y < 30; y += 0.5f)
    for (float x = -30; x < 30; x += 0.5f) {
      points.positions.emplace_back(x, y, 0);
      points.normals.emplace_back(0, 0, 1);
      points.confidence.push_back(1);
    }
  return points;
}

// The volume of the plate: bright below it, to z = -3, and from z = 20 to 24, where x > 0; fluid elsewhere.
Volume<float> volumeOfPlate() {
  Geometry geometry;
  geometry.dims = {61, 61, 61};
  geometry.spacing = glm::dvec3(1.2);
  geometry.origin = glm::dvec3(-36);
  Volume<float> volume(geometry);
  for (int k = 0; k < 61; ++k)
    for (int j = 0; j < 61; ++j)
      for (int i = 0; i < 61; ++i) {
        const glm::dvec3 p = geometry.toWorld({i, j, k});
        const bool lid = p.z > 20 && p.z < 24 && p.x > 0;
        volume.at(i, j, k) = (p.z < 0 && p.z > -3) || lid ? 0.8f : 0.f;
      }
  return volume;
}

const Beam kDown{std::nullopt, {0, 0, -1}, {0, 1, 0}};

TEST(FaceSpace, TheNearestSurfelIsNearlyTheNearestPoint) {
  const SurfacePoints points = plate();
  const FaceSpace space({points});
  for (std::uint32_t n = 0; n < 500; ++n) {
    const vec3 p = vec3(50 * uniformAt(3 * n, 9) - 25, 50 * uniformAt(3 * n + 1, 9) - 25,
                        8 * uniformAt(3 * n + 2, 9) - 4);
    const Surfel* surfel = space.nearest(p);
    ASSERT_NE(surfel, nullptr);
    EXPECT_LT(glm::distance(surfel->place, p), std::abs(p.z) + 2 * space.cell());
    EXPECT_GT(surfel->normal.z, 0.99f);
  }
  EXPECT_EQ(space.nearest(vec3(0, 0, 100)), nullptr);
}

TEST(FaceSpace, FluidBeforeASurfaceIsFreeAndBehindItNot) {
  const SurfacePoints points = plate();
  const Volume<float> volume = volumeOfPlate();
  const FaceSpace space({points, &volume, 0.4f, kDown});
  EXPECT_EQ(space.kind(vec3(-10, 0, 5)), FaceSpace::Kind::free);
  EXPECT_EQ(space.kind(vec3(10, 0, 5)), FaceSpace::Kind::free);
  EXPECT_EQ(space.kind(vec3(0, 0, -1.5f)), FaceSpace::Kind::unknown) << "tissue";
  EXPECT_EQ(space.kind(vec3(0, 0, -5)), FaceSpace::Kind::dark) << "shadow";
  EXPECT_EQ(space.kind(vec3(0, 0, 300)), FaceSpace::Kind::unknown) << "outside";
}

TEST(FaceSpace, StrayPointsAreNoSurface) {
  SurfacePoints points = plate();
  points.positions.emplace_back(3, 3, 7);
  points.normals.emplace_back(0, 0, 1);
  points.confidence.push_back(1);
  const FaceSpace space({points});
  EXPECT_GT(space.surfels().size(), 5000u);
  for (const Surfel& surfel : space.surfels()) EXPECT_LT(surfel.place.z, 1);
}

TEST(FaceSpace, NothingIsNearNothing) {
  const SurfacePoints none;
  const FaceSpace space({none});
  EXPECT_EQ(space.nearest(vec3(0)), nullptr);
  EXPECT_EQ(space.kind(vec3(0)), FaceSpace::Kind::unknown);
}

}  // namespace
}  // namespace sonoskin
