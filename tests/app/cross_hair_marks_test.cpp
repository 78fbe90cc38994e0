#include "app/views/cross_hair_marks.h"

#include <gtest/gtest.h>

namespace sonoskin::ui {
namespace {

// A wall across j in the middle; what lies behind it is hidden, but not where the wall is cropped away.
TEST(CrossHairSight, AVolumeHidesWhatIsBehindItsSurface) {
  Geometry g;
  g.dims = {20, 30, 20};
  g.spacing = {0.5, 0.5, 0.5};
  auto volume = std::make_shared<Volume<float>>(g);
  for (int k = 0; k < 20; ++k)
    for (int i = 0; i < 20; ++i) volume->at(i, 15, k) = 0.8f;
  VolumeScene scene{.volume = volume};
  scene.level = 0.5f;
  const glm::vec3 eye(g.toWorld({10, -200, 10}));
  EXPECT_FALSE(isBehindVolume(scene, eye, glm::vec3(g.toWorld({10, 5, 10}))));
  EXPECT_FALSE(isBehindVolume(scene, eye, glm::vec3(g.toWorld({10, 15, 10})))) << "on the wall itself";
  EXPECT_TRUE(isBehindVolume(scene, eye, glm::vec3(g.toWorld({10, 25, 10}))));
  scene.part.cropMin.y = 0.6f;
  EXPECT_FALSE(isBehindVolume(scene, eye, glm::vec3(g.toWorld({10, 25, 10}))));
}

}  // namespace
}  // namespace sonoskin::ui
