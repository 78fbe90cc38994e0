#include "core/surface/clusters.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

const glm::ivec3 kDims(14, 13, 12);

// Random voxels in memory order.
std::vector<SurfaceVoxel> scattered(double density) {
  std::vector<SurfaceVoxel> voxels;
  std::uint64_t n = 0;
  for (int k = 0; k < kDims.z; ++k)
    for (int j = 0; j < kDims.y; ++j)
      for (int i = 0; i < kDims.x; ++i)
        if (test::noise(n++) < density) voxels.push_back({{i, j, k}, {i, j, k}, float(test::noise(n + 999))});
  return voxels;
}

// Labels by asking every pair, until nothing changes.
std::vector<int> bruteForceLabels(const std::vector<SurfaceVoxel>& voxels) {
  std::vector<int> label(voxels.size());
  for (std::size_t a = 0; a < voxels.size(); ++a) label[a] = int(a);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t a = 0; a < voxels.size(); ++a)
      for (std::size_t b = 0; b < voxels.size(); ++b) {
        const glm::ivec3 d = glm::abs(voxels[a].voxel - voxels[b].voxel);
        if (std::max({d.x, d.y, d.z}) > 1 || label[b] >= label[a]) continue;
        label[a] = label[b];
        changed = true;
      }
  }
  return label;
}

TEST(Clusters, AgreeWithBruteForce) {
  for (const double density : {0.03, 0.06, 0.1, 0.3}) {
    const auto voxels = scattered(density);
    EXPECT_EQ(labelClusters(voxels, kDims), bruteForceLabels(voxels)) << density;
  }
}

TEST(Clusters, SmallAndWeakPiecesAreDropped) {
  std::vector<SurfaceVoxel> voxels;
  const auto line = [&](int j, int length, float value) {
    for (int i = 0; i < length; ++i) voxels.push_back({{i, j, 2}, {i, j, 2}, value});
  };
  line(0, 12, 0.9f);  // long and strong
  line(3, 12, 0.2f);  // long and weak
  line(6, 4, 0.9f);   // short and strong
  SurfaceOptions o;
  o.minClusterArea = 10;
  const auto kept = dropWeakClusters(voxels, test::grid(kDims), o);
  ASSERT_EQ(kept.size(), 12u);
  for (const auto& v : kept) EXPECT_EQ(v.voxel.y, 0);
}

TEST(Clusters, WeakVoxelsLiveOnStrongNeighbours) {
  std::vector<SurfaceVoxel> voxels;
  for (int i = 0; i < 12; ++i) voxels.push_back({{i, 0, 0}, {i, 0, 0}, i < 5 ? 0.9f : 0.12f});
  SurfaceOptions o;
  o.minClusterArea = 10;
  EXPECT_EQ(dropWeakClusters(voxels, test::grid(kDims), o).size(), 12u);
}

// The same 12 voxels cover eight times the area where voxels are 2 x 2 x 5.66 mm.
TEST(Clusters, AreMeasuredInSquareMillimetres) {
  std::vector<SurfaceVoxel> voxels;
  for (int i = 0; i < 12; ++i) voxels.push_back({{i, 0, 0}, {i, 0, 0}, 0.9f});
  SurfaceOptions o;
  o.minClusterArea = 90;
  EXPECT_TRUE(dropWeakClusters(voxels, test::grid(kDims), o).empty());
  EXPECT_EQ(dropWeakClusters(voxels, test::grid(kDims, {2, 2, std::sqrt(32.0)}), o).size(), 12u);
}

TEST(Clusters, TheLargestAloneNeedsNoStrength) {
  std::vector<SurfaceVoxel> voxels;
  const auto line = [&](int j, int length, float value) {
    for (int i = 0; i < length; ++i) voxels.push_back({{i, j, 2}, {i, j, 2}, value});
  };
  line(0, 8, 0.9f);
  line(3, 12, 0.2f);
  line(6, 12, 0.9f);  // as large as the one before: the first counts
  SurfaceOptions o;
  o.clusters = ClusterRule::largest;
  o.minClusterArea = 10;
  const auto kept = dropWeakClusters(voxels, test::grid(kDims), o);
  ASSERT_EQ(kept.size(), 12u);
  for (const auto& v : kept) EXPECT_EQ(v.voxel.y, 3);
  o.minClusterArea = 13;
  EXPECT_TRUE(dropWeakClusters(voxels, test::grid(kDims), o).empty());
}

TEST(Clusters, OfNothingAreNothing) {
  SurfaceOptions o;
  EXPECT_TRUE(dropWeakClusters({}, test::grid(kDims), o).empty());
  o.clusters = ClusterRule::largest;
  EXPECT_TRUE(dropWeakClusters({}, test::grid(kDims), o).empty());
}

}  // namespace
}  // namespace sonoskin
