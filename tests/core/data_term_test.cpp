#include "core/classification/data_term.h"

#include <gtest/gtest.h>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A ramp has one gradient, so every inner voxel has a closed form.
TEST(DataTerm, OfARampIsTheFormula) {
  const Geometry g = test::grid({9, 9, 9}, {1, 2, 1});
  const auto ramp = test::fill(g, [](glm::dvec3 p) { return 0.02 * p.x + 0.03 * p.y; });  // per mm
  auto raw = ramp;
  for (float& v : raw.data) v += 0.05f;
  ClassificationOptions o;
  o.alpha = 0.8;
  o.gamma = 0.6;
  o.isoValue = 0.25;
  o.rawShare = 0.4;
  o.noiseFloor = 0.02;
  o.target = 0.9;
  const DataTerm term = dataTerm({raw, ramp, o});
  const double g2 = 0.02 * 0.02 + 0.03 * 0.03, low = 0.02 * 3 + 0.03 * 8 - 0.25, high = low + 0.05;
  const double a = (0.4 * high * high + 0.6 * low * low + 0.0004) / (g2 + 1.5e-5);
  const double h = 0.1 + 0.9 * std::sqrt(g2) / 0.1;
  EXPECT_NEAR(term.diagonal[g.index(3, 4, 5)], 0.8 * a + 0.6 * h, 1e-4);
  EXPECT_NEAR(term.right[g.index(3, 4, 5)], 0.6 * h * 0.9, 1e-6);
}

// Each axis has its own spacing; on the volume's sides there is no gradient; beyond the reference a steeper one counts no more.
TEST(DataTerm, GradientsAreTakenAlongEveryAxisButNotOnTheSides) {
  const Geometry g = test::grid({8, 7, 6}, {1, 2, 1.5});
  ClassificationOptions o;
  o.isoValue = 0.3;
  for (int axis = 0; axis < 3; ++axis) {
    const auto ramp = test::fill(g, [&](glm::dvec3 p) { return 0.06 * p[axis]; });
    const DataTerm term = dataTerm({ramp, ramp, o});
    for (int k = 0; k < g.dims.z; ++k)
      for (int j = 0; j < g.dims.y; ++j)
        for (int i = 0; i < g.dims.x; ++i) {
          const glm::ivec3 at(i, j, k);
          const bool onSide = glm::any(glm::equal(at, glm::ivec3(0))) || glm::any(glm::equal(at, g.dims - 1));
          ASSERT_NEAR(term.right[g.index(i, j, k)], 0.1 + (onSide ? 0 : 0.9 * 0.6), 1e-5) << axis;
        }
  }
  const auto steep = test::fill(g, [&](glm::dvec3 p) { return 0.3 * p.x; });
  EXPECT_NEAR(dataTerm({steep, steep, o}).right[g.index(3, 3, 3)], 1, 1e-6);
}

TEST(DataTerm, IsBoundedFarFromTheIsoValue) {
  const Geometry g = test::grid({6, 6, 6});
  ClassificationOptions o;
  o.isoValue = 0.9;
  const Volume<float> flat(g, 0.0f);
  const DataTerm term = dataTerm({flat, flat, o});
  EXPECT_NEAR(term.diagonal[g.index(3, 3, 3)], 256 + 0.1, 1e-3);  // alpha 16^2 + gamma delta
}

TEST(DataTerm, FarthestIsTheBound) {
  const Geometry g = test::grid({6, 6, 6});
  ClassificationOptions o;
  o.isoValue = 0.9;
  o.farthest = 5;
  const Volume<float> flat(g, 0.0f);
  EXPECT_NEAR(dataTerm({flat, flat, o}).diagonal[g.index(3, 3, 3)], 25 + 0.1, 1e-4);
}

// With all the weight on one volume the other counts through its gradients alone.
TEST(DataTerm, GradientsComeFromTheChosenVolume) {
  const Geometry g = test::grid({7, 7, 7});
  const auto steep = test::fill(g, [](glm::dvec3 p) { return 0.09 * p.x; });
  const auto gentle = test::fill(g, [](glm::dvec3 p) { return 0.02 * p.x + 0.2; });
  ClassificationOptions o;
  o.isoValue = 0.3;
  o.gamma = 2;
  const std::size_t middle = g.index(3, 3, 3);
  EXPECT_NEAR(dataTerm({steep, gentle, o}).right[middle], 2 * (0.1 + 0.9 * 0.2), 1e-5);
  o.gradientSource = GradientSource::raw;
  EXPECT_NEAR(dataTerm({steep, gentle, o}).right[middle], 2 * (0.1 + 0.9 * 0.9), 1e-5);
}

TEST(DataTerm, BetaFollowsTheTangentialLength) {
  ClassificationOptions o;  // gamma 1, delta 0.1, gref 0.1: h at 0.06 is 0.1 + 0.9 * 0.6
  EXPECT_NEAR(absoluteBeta(o), 9 * 0.64, 1e-12);
  o.beta = 3;
  o.gamma = 2;
  o.gradientReference = 0.05;  // steeper at 0.06: h is gamma
  EXPECT_NEAR(absoluteBeta(o), 3 * 9 * 2, 1e-12);
  o.tangentialLength = 0;
  EXPECT_EQ(absoluteBeta(o), 0);
}

}  // namespace
}  // namespace sonoskin
