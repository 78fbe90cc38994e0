#include "render/light_volume.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

Volume<float> fog() {
  Geometry g;
  g.dims = {32, 40, 24};
  g.spacing = {1, 0.5, 2};
  return Volume<float>(g, 1.0f);
}

const TransferFunction kThin{{{0, glm::vec3(1), 0}, {1, glm::vec3(1), 0.02f}}};

TEST(LightVolume, FollowsBeersLawInFog) {
  const Volume<float> volume = fog();
  const Volume<float> light = lightVolume(extinctionVolume(volume, kThin, 4), {0, -1, 0});
  EXPECT_EQ(light.geometry.dims, glm::ivec3(8, 10, 6));
  const double extinction = extinctionPerMm(0.02f, worldDiagonal(volume.geometry));
  for (int j = 0; j < 10; ++j)
    EXPECT_NEAR(light.at(4, j, 3), std::exp(-extinction * 2.0 * j), 1e-4) << j;  // cells of 2 mm
}

TEST(LightVolume, LayersMultiply) {
  // 250 layers of opacity a make up the diagonal.
  const double perMm = extinctionPerMm(0.3f, 100);
  EXPECT_NEAR(std::exp(-perMm * 100), std::pow(0.7, 250), 1e-6);
  EXPECT_NEAR(std::exp(-perMm * 0.4), 0.7, 1e-6);
}

TEST(LightVolume, TurnsWithTheVolume) {
  Volume<float> volume = fog();
  volume.geometry.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  // j now points along -x: light from +x comes from low j.
  const Volume<float> light = lightVolume(extinctionVolume(volume, kThin, 4), {1, 0, 0});
  EXPECT_GT(light.at(4, 1, 3), light.at(4, 8, 3));
}

TEST(LightVolume, DoesNotDependOnTheThreads) {
  const glm::vec3 toLight = glm::normalize(glm::vec3(1, -2, 0.5f));
  setThreadCount(1);
  const auto one = lightVolume(extinctionVolume(fog(), kThin, 4), toLight);
  setThreadCount(3);
  const auto three = lightVolume(extinctionVolume(fog(), kThin, 4), toLight);
  setThreadCount(0);
  EXPECT_EQ(one.data, three.data);
}

}  // namespace
}  // namespace sonoskin
