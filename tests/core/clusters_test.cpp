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

TEST(Clusters, AStrongVoxelHasTheThresholdOrMore) {
  std::vector<SurfaceVoxel> voxels;
  for (int i = 0; i < 12; ++i) voxels.push_back({{i, 0, 0}, {i, 0, 0}, 0.5f});
  SurfaceOptions o;
  o.minClusterArea = 10;
  o.strongThreshold = 0.5;
  EXPECT_EQ(dropWeakClusters(voxels, test::grid(kDims), o).size(), 12u);
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

// A piece is weighed by its strong voxels beside those of the piece with most.
TEST(Clusters, SpecksBesideALargePieceAreDropped) {
  std::vector<SurfaceVoxel> voxels;
  const auto sheet = [&](int k, int width, float value) {
    for (int j = 0; j < width; ++j)
      for (int i = 0; i < width; ++i) voxels.push_back({{i, j, k}, {i, j, k}, value});
  };
  sheet(0, 12, 0.9f);  // 144 strong ones
  sheet(3, 3, 0.9f);   // 9
  sheet(6, 12, 0.4f);  // none
  SurfaceOptions o;
  o.minClusterArea = 4;
  o.strongShare = 0.06;
  const auto kept = [&] { return dropWeakClusters(voxels, test::grid(kDims), o).size(); };
  EXPECT_EQ(kept(), 144u + 9);
  o.strongShare = 0.07;
  EXPECT_EQ(kept(), 144u);
  for (SurfaceVoxel& v : voxels) v.value *= 0.5f;  // a noisy scan: weak everywhere
  o.strongThreshold = 0.25;
  EXPECT_EQ(kept(), 144u);
}

// Two sheets in one plane, joined by a bridge of a voxel's width.
std::vector<SurfaceVoxel> sheetWithLobe(int lobeWidth, float lobeValue) {
  std::vector<SurfaceVoxel> voxels;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 70; ++i) {
      const bool main = i < 40, bridge = i < 45 && j == 5, lobe = i >= 45 && i < 45 + lobeWidth && j < 15;
      if (main || bridge || lobe) voxels.push_back({{i, j, 2}, {i, j, 2}, lobe ? lobeValue : 0.9f});
    }
  return voxels;
}

const glm::ivec3 kWide(80, 40, 5);

TEST(Lobes, ArePartedAtNecks) {
  const auto voxels = sheetWithLobe(15, 0.9f);
  const auto labels = labelLobes(voxels, kWide);
  const auto labelAt = [&](int i, int j) {
    for (std::size_t v = 0; v < voxels.size(); ++v)
      if (voxels[v].voxel.x == i && voxels[v].voxel.y == j) return labels[v];
    return -1;
  };
  EXPECT_EQ(labelAt(0, 0), labelAt(39, 39));  // borders go with what they surround
  EXPECT_EQ(labelAt(45, 0), labelAt(59, 14));
  EXPECT_NE(labelAt(0, 0), labelAt(50, 7));
  std::map<int, int> pieces;
  for (const int label : labelClusters(voxels, kWide)) ++pieces[label];
  EXPECT_EQ(pieces.size(), 1u);
}

TEST(Lobes, WeakOnesAreDropped) {
  SurfaceOptions o;
  o.minClusterArea = 60;
  const std::size_t main = 40 * 40;
  const auto kept = [&](int width, float value) {
    return dropLooseLobes(sheetWithLobe(width, value), test::grid(kWide), o).size();
  };
  EXPECT_EQ(kept(15, 0.2f), main + 5);            // weak: a loose sheet; the bridge stays
  EXPECT_EQ(kept(15, 0.9f), main + 5 + 15 * 15);  // strong
  EXPECT_EQ(kept(3, 0.2f), main + 5 + 3 * 15);    // smaller than minClusterArea: a torn edge
  o.lobeStrength = 0;
  EXPECT_EQ(kept(15, 0.2f), main + 5 + 15 * 15);  // switched off
  o.lobeStrength = 0.5;
  o.clusters = ClusterRule::largest;
  EXPECT_EQ(kept(15, 0.2f), main + 5 + 15 * 15);
}

// The main lobe may hold the very first voxel, and a weak one the last.
TEST(Lobes, TheirOrderDoesNotMatter) {
  std::vector<SurfaceVoxel> voxels{{{5, 5, 1}, {5, 5, 1}, 0.9f}};  // an apex: with the nine below it, inner
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 60; ++i) {
      const bool main = i < 40, bridge = i < 45 && j == 33, lobe = i >= 45 && j >= 25;
      if (main || bridge || lobe) voxels.push_back({{i, j, 2}, {i, j, 2}, lobe ? 0.2f : 0.9f});
    }
  EXPECT_EQ(labelLobes(voxels, kWide)[0], 0);
  SurfaceOptions o;
  o.minClusterArea = 60;
  EXPECT_EQ(dropLooseLobes(voxels, test::grid(kWide), o).size(), 1u + 40 * 40 + 5);
}

// A second face is no lobe: it is large.
TEST(Lobes, LargeOnesStay) {
  std::vector<SurfaceVoxel> voxels;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 70; ++i)
      if (i < 40 || j == 5 || i >= 45) voxels.push_back({{i, j, 2}, {i, j, 2}, i >= 45 ? 0.2f : 0.9f});
  EXPECT_EQ(dropLooseLobes(voxels, test::grid(kWide), {}).size(), voxels.size());
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
  EXPECT_TRUE(dropLooseLobes({}, test::grid(kDims), o).empty());
  o.clusters = ClusterRule::largest;
  EXPECT_TRUE(dropWeakClusters({}, test::grid(kDims), o).empty());
}

}  // namespace
}  // namespace sonoskin
