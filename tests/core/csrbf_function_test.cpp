#include "core/rbf/compact/csrbf_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

// Bricks along the surface of a ball and away from it: the function's sums are those over all centres.
TEST(CsrbfFunction, EqualsTheModel) {
  constexpr float kCell = 0.7f;
  ReconstructionOptions options;
  options.fitWeights = true;
  const CsrbfModel model = fitCsrbf(spherePoints(3000, 10, 0.1), options);
  const ImplicitFunction function = csrbfFunction(model, kCell);
  EXPECT_EQ(function.cell, kCell);
  int defined = 0, undefined = 0;
  for (int b = 0; b < 60; ++b) {
    const float angle = 0.3f * float(b), far = 6 + 0.15f * float(b);
    const glm::vec3 corner = far * glm::vec3(std::cos(angle), std::sin(angle), 0.2f * std::sin(3 * angle));
    float value[kBrickNodes], coverage[kBrickNodes];
    function.sampleBrick(corner, value, coverage);
    for (int n = 0; n < int(kBrickNodes); ++n) {
      const CsrbfModel::Sample expected = model.sample(corner + kCell * glm::vec3(nodePlace(n)));
      ASSERT_NEAR(coverage[n], expected.coverage, 2e-5f);
      if (std::isnan(value[n])) {
        ASSERT_LT(expected.coverage, 0.011f);
        ++undefined;
      } else {
        ASSERT_NEAR(value[n], expected.value, 2e-3f);
        ++defined;
      }
    }
  }
  EXPECT_GT(defined, 500);
  EXPECT_GT(undefined, 100);
}

TEST(CsrbfFunction, ItsGradientsPointAsTheModelsOnTheSurface) {
  constexpr float kCell = 0.7f;
  const CsrbfModel model = fitCsrbf(spherePoints(3000, 10, 0.1), {});
  const ImplicitFunction function = csrbfFunction(model, kCell);
  for (int b = 0; b < 20; ++b) {
    const glm::vec3 direction(std::cos(0.3f * float(b)), std::sin(0.3f * float(b)), 0);
    std::vector<glm::vec3> places;
    for (int i = 0; i < 70; ++i) {  // more than one block of them
      glm::vec3 p = 10.f * glm::normalize(direction + 0.001f * glm::vec3(i, -i, 2 * i));
      for (int step = 0; step < 3; ++step) p -= model.sample(p).value * glm::normalize(model.gradient(p));
      places.push_back(p);
    }
    std::vector<glm::vec3> gradients(places.size());
    function.gradients(10.f * direction, places, gradients.data());
    for (std::size_t i = 0; i < places.size(); ++i)
      ASSERT_GT(glm::dot(glm::normalize(gradients[i]), glm::normalize(model.gradient(places[i]))), 0.9999f);
  }
}

}  // namespace
}  // namespace sonoskin
