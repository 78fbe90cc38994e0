#include "core/mesh/facts/measured_facts.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/mesh/repair/clip.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

TEST(MeasuredFacts, CountHolesAndAreas) {
  const double pi = std::numbers::pi;
  Mesh mesh = test::icosphere(6, 10, {});
  EXPECT_NEAR(measureFilled(mesh).measured, 400 * pi, 1);
  EXPECT_EQ(measureFilled(mesh).holes, 0u);
  // Two caps of height 1 were filled, and a strip above z = -6, where the sphere is cut.
  std::vector<float> keep;
  for (const glm::vec3& p : mesh.positions) {
    const bool isFilled = p.z > 9 || p.x > 9 || p.z < -5.5f;
    mesh.measured.push_back(isFilled ? 0.f : 1.f);
    keep.push_back(p.z + 6);
  }
  const Mesh cut = clipMesh(mesh, keep);
  const MeasuredFacts facts = measureFilled(cut);
  EXPECT_EQ(facts.holes, 2u);
  EXPECT_NEAR(facts.filled, 2 * 20 * pi, 5);
  EXPECT_NEAR(facts.measured, 20 * pi * 15.5 - 2 * 20 * pi, 10);
}

}  // namespace
}  // namespace sonoskin
