#include "core/pipeline/slice_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/volume/resample.h"
#include "tests/core/support/pipeline_fixture.h"

namespace sonoskin {
namespace {

using SliceSolverTest = PipelineTest;

// slicesOf: the three slices through a voxel, as Pipeline::slices gives them.
std::array<Volume<float>, 3> slicesOf(const Volume<float>& u, const glm::ivec3& voxel) {
  std::array<Volume<float>, 3> slices;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 first(0), dims = u.geometry.dims;
    first[axis] = voxel[axis];
    dims[axis] = 1;
    slices[std::size_t(axis)] = cropVolume(u, first, dims);
  }
  return slices;
}

TEST_F(SliceSolverTest, SlicesAreThoseOfTheWholeVolume) {
  const glm::ivec3 voxel(30, 31, 12);
  EXPECT_FALSE(pipeline.slices(scan, parameters, voxel).slices[0]) << "nothing is known of the volume yet";
  pipeline.run(scan, parameters, Goal::classified);
  parameters.classification.beta = 2;
  parameters.classification.alpha *= 0.8;
  std::vector<std::ptrdiff_t> there;
  const Results quick = pipeline.slices(scan, parameters, voxel, {}, [&](const Results& some) {
    there.push_back(std::ranges::count_if(some.slices, [](const auto& slice) { return slice != nullptr; }));
  });
  EXPECT_EQ(there, (std::vector<std::ptrdiff_t>{1, 2, 3})) << "none waits for the others";
  EXPECT_FALSE(quick.classified);
  const auto whole = slicesOf(*pipeline.run(scan, parameters, Goal::classified).classified, voxel);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ASSERT_TRUE(quick.slices[axis]);
    const Volume<float>&slice = *quick.slices[axis], &expected = whole[axis];
    ASSERT_EQ(slice.geometry.dims, expected.geometry.dims);
    EXPECT_LT(glm::distance(slice.geometry.origin, expected.geometry.origin), 1e-9);
    float most = 0, sum = 0;
    for (std::size_t i = 0; i < slice.data.size(); ++i) {
      const float error = std::abs(slice.data[i] - expected.data[i]);
      most = std::max(most, error);
      sum += error;
    }
    EXPECT_LT(most, 0.15f) << axis;
    EXPECT_LT(sum / float(slice.data.size()), 0.01f) << axis;
    EXPECT_GT(*std::ranges::max_element(expected.data), 0.3f) << "the ball is seen";
  }
}

TEST_F(SliceSolverTest, SlicesOfAPartOfTheVolumeOnly) {
  parameters.classification.formulation = Formulation::thesisClosed;
  pipeline.run(scan, parameters, Goal::classified);
  EXPECT_FALSE(pipeline.slices(scan, parameters, {30, 30, 20}).slices[0]) << "the formula is as fast";
  parameters = parametersForTests();
  pipeline.run(scan, parameters, Goal::classified);
  parameters.classification.lowPass = 2;
  EXPECT_FALSE(pipeline.slices(scan, parameters, {30, 30, 20}).slices[0]) << "of another low-passed volume";
}

}  // namespace
}  // namespace sonoskin
