#include "core/surface/clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sonoskin {
namespace {

// Union by the smaller index, so that a root is the first voxel of its piece.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int a) {
    while (parent_[std::size_t(a)] != a) {
      parent_[std::size_t(a)] = parent_[std::size_t(parent_[std::size_t(a)])];
      a = parent_[std::size_t(a)];
    }
    return a;
  }
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

// Where each row (j, k) of the volume begins in the list of voxels.
std::vector<int> rowStarts(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims) {
  std::vector<int> start(std::size_t(dims.y) * std::size_t(dims.z) + 1, 0);
  for (const SurfaceVoxel& v : voxels)
    ++start[std::size_t(v.voxel.z) * std::size_t(dims.y) + std::size_t(v.voxel.y) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  return start;
}

// Joins the voxels of two neighbouring rows whose i differ by at most one; both are sorted by i.
void joinRows(const std::vector<SurfaceVoxel>& voxels, int a, int aEnd, int b, int bEnd, DisjointSets& sets) {
  for (; a < aEnd; ++a) {
    const int i = voxels[std::size_t(a)].voxel.x;
    while (b < bEnd && voxels[std::size_t(b)].voxel.x < i - 1) ++b;
    for (int c = b; c < bEnd && voxels[std::size_t(c)].voxel.x <= i + 1; ++c) sets.join(a, c);
  }
}

// The piece with most voxels, the first of equals; nothing if it has fewer than `smallest`.
std::vector<SurfaceVoxel> largestCluster(const std::vector<SurfaceVoxel>& voxels,
                                         const std::vector<int>& labels, double smallest) {
  std::vector<int> size(voxels.size(), 0);
  for (const int label : labels) ++size[std::size_t(label)];
  const auto largest = std::max_element(size.begin(), size.end());
  std::vector<SurfaceVoxel> kept;
  if (largest == size.end() || *largest < smallest) return kept;
  const int piece = int(largest - size.begin());
  for (std::size_t v = 0; v < voxels.size(); ++v)
    if (labels[v] == piece) kept.push_back(voxels[v]);
  return kept;
}

}  // namespace

std::vector<int> labelClusters(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims) {
  const std::vector<int> start = rowStarts(voxels, dims);
  DisjointSets sets(voxels.size());
  const auto joinWith = [&](int j, int k, int row) {
    if (j < 0 || k < 0 || j >= dims.y) return;
    const std::size_t other = std::size_t(k) * std::size_t(dims.y) + std::size_t(j), own = std::size_t(row);
    joinRows(voxels, start[own], start[own + 1], start[other], start[other + 1], sets);
  };
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j) {
      const int row = k * dims.y + j;
      for (int c = start[std::size_t(row)] + 1; c < start[std::size_t(row) + 1]; ++c)
        if (voxels[std::size_t(c)].voxel.x == voxels[std::size_t(c - 1)].voxel.x + 1) sets.join(c, c - 1);
      joinWith(j - 1, k, row);
      for (int dj = -1; dj <= 1; ++dj) joinWith(j + dj, k - 1, row);
    }
  std::vector<int> labels(voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) labels[v] = sets.root(int(v));
  return labels;
}

std::vector<SurfaceVoxel> dropWeakClusters(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                           const SurfaceOptions& options) {
  const std::vector<int> labels = labelClusters(voxels, geometry.dims);
  const glm::dvec3& spacing = geometry.spacing;
  const double smallest = options.minClusterArea / std::pow(spacing.x * spacing.y * spacing.z, 2.0 / 3.0);
  if (options.clusters == ClusterRule::largest) return largestCluster(voxels, labels, smallest);
  std::vector<int> size(voxels.size(), 0), strong(voxels.size(), 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    ++size[std::size_t(labels[v])];
    if (double(voxels[v].value) >= options.strongThreshold) ++strong[std::size_t(labels[v])];
  }
  const double fewestStrong = std::min(30.0, smallest / 3);
  std::vector<SurfaceVoxel> kept;
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const std::size_t piece = std::size_t(labels[v]);
    if (size[piece] >= smallest && strong[piece] >= fewestStrong &&
        strong[piece] >= options.strongShare * size[piece])
      kept.push_back(voxels[v]);
  }
  return kept;
}

}  // namespace sonoskin
