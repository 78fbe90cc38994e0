#include "core/surface/clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/disjoint_sets.h"

namespace sonoskin {
namespace {

constexpr int kInnerNeighbours = 8;  // a flat sheet's voxel has 8
constexpr double kLobeShare = 0.25;

// Of every voxel the first one of its piece.
std::vector<int> rootsOf(DisjointSets& sets, std::size_t count) {
  std::vector<int> roots(count);
  for (std::size_t v = 0; v < count; ++v) roots[v] = int(sets.root(std::uint32_t(v)));
  return roots;
}

// Where each row (j, k) of the volume begins in the list of voxels.
std::vector<int> rowStarts(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims) {
  std::vector<int> start(std::size_t(dims.y) * std::size_t(dims.z) + 1, 0);
  for (const SurfaceVoxel& v : voxels)
    ++start[std::size_t(v.voxel.z) * std::size_t(dims.y) + std::size_t(v.voxel.y) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  return start;
}

// Calls touch(a, b) for every pair of voxels that touch by a face, an edge or a corner, b before a.
template <class Touch>
void forEachTouch(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims, const Touch& touch) {
  const std::vector<int> start = rowStarts(voxels, dims);
  const auto alongI = [&](int v) { return voxels[std::size_t(v)].voxel.x; };
  const auto touchRow = [&](std::size_t row, int j, int k) {
    if (j < 0 || k < 0 || j >= dims.y) return;
    const std::size_t other = std::size_t(k) * std::size_t(dims.y) + std::size_t(j);
    int b = start[other];
    const int bEnd = start[other + 1];
    for (int a = start[row]; a < start[row + 1]; ++a) {
      while (b < bEnd && alongI(b) < alongI(a) - 1) ++b;
      for (int c = b; c < bEnd && alongI(c) <= alongI(a) + 1; ++c) touch(a, c);
    }
  };
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j) {
      const std::size_t row = std::size_t(k) * std::size_t(dims.y) + std::size_t(j);
      if (start[row] == start[row + 1]) continue;
      for (int a = start[row] + 1; a < start[row + 1]; ++a)
        if (alongI(a) == alongI(a - 1) + 1) touch(a, a - 1);
      touchRow(row, j - 1, k);
      for (int dj = -1; dj <= 1; ++dj) touchRow(row, j + dj, k - 1);
    }
}

// How many voxels, and how many strong ones, have each label.
struct Counts {
  std::vector<int> size, strong;

  Counts(const std::vector<SurfaceVoxel>& voxels, const std::vector<int>& labels, double strongThreshold)
      : size(voxels.size(), 0), strong(voxels.size(), 0) {
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      ++size[std::size_t(labels[v])];
      strong[std::size_t(labels[v])] += double(voxels[v].value) >= strongThreshold;
    }
  }
};

// minClusterArea in voxels.
double smallestSize(const Geometry& geometry, const SurfaceOptions& options) {
  const glm::dvec3& spacing = geometry.spacing;
  return options.minClusterArea / std::pow(spacing.x * spacing.y * spacing.z, 2.0 / 3.0);
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

// For every piece its lobe with most strong voxels.
std::vector<int> mainLobes(const std::vector<int>& pieces, const std::vector<int>& lobes,
                           const Counts& count) {
  std::vector<int> main(pieces.size(), -1);
  for (std::size_t v = 0; v < pieces.size(); ++v) {
    int& best = main[std::size_t(pieces[v])];
    if (best < 0 || count.strong[std::size_t(lobes[v])] > count.strong[std::size_t(best)]) best = lobes[v];
  }
  return main;
}

}  // namespace

std::vector<int> labelClusters(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims) {
  DisjointSets sets(voxels.size());
  forEachTouch(voxels, dims, [&](int a, int b) { sets.join(std::uint32_t(a), std::uint32_t(b)); });
  return rootsOf(sets, voxels.size());
}

std::vector<SurfaceVoxel> dropWeakClusters(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                           const SurfaceOptions& options) {
  const std::vector<int> labels = labelClusters(voxels, geometry.dims);
  const double smallest = smallestSize(geometry, options);
  if (options.clusters == ClusterRule::largest) return largestCluster(voxels, labels, smallest);
  const Counts count(voxels, labels, options.strongThreshold);
  const auto most = std::max_element(count.strong.begin(), count.strong.end());
  const double enough = most == count.strong.end() ? 0 : options.strongShare * *most;
  const double fewestStrong = std::max(std::min(30.0, smallest / 3), enough);
  std::vector<SurfaceVoxel> kept;
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const std::size_t piece = std::size_t(labels[v]);
    if (count.size[piece] >= smallest && count.strong[piece] >= fewestStrong) kept.push_back(voxels[v]);
  }
  return kept;
}

std::vector<int> labelLobes(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims) {
  std::vector<int> neighbours(voxels.size(), 0);
  forEachTouch(voxels, dims,
               [&](int a, int b) { ++neighbours[std::size_t(a)], ++neighbours[std::size_t(b)]; });
  const auto isInner = [&](int v) { return neighbours[std::size_t(v)] >= kInnerNeighbours; };
  DisjointSets sets(voxels.size());
  std::vector<int> host(voxels.size());  // of an outer voxel: the first inner one that it touches
  std::iota(host.begin(), host.end(), 0);
  const auto attach = [&](int outer, int inner) {
    int& at = host[std::size_t(outer)];
    if (at == outer || inner < at) at = inner;
  };
  forEachTouch(voxels, dims, [&](int a, int b) {
    if (isInner(a) && isInner(b)) sets.join(std::uint32_t(a), std::uint32_t(b));
    if (isInner(a) && !isInner(b)) attach(b, a);
    if (!isInner(a) && isInner(b)) attach(a, b);
  });
  const std::vector<int> roots = rootsOf(sets, voxels.size());
  std::vector<int> labels(voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) labels[v] = roots[std::size_t(host[v])];
  return labels;
}

std::vector<SurfaceVoxel> dropLooseLobes(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                         const SurfaceOptions& options) {
  if (options.clusters == ClusterRule::largest || options.lobeStrength <= 0) return voxels;
  const std::vector<int> pieces = labelClusters(voxels, geometry.dims),
                         lobes = labelLobes(voxels, geometry.dims);
  const Counts count(voxels, lobes, options.strongThreshold);
  const std::vector<int> main = mainLobes(pieces, lobes, count);
  const double smallest = smallestSize(geometry, options);
  const auto shareOf = [&](std::size_t lobe) { return double(count.strong[lobe]) / count.size[lobe]; };
  std::vector<SurfaceVoxel> kept;
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const std::size_t lobe = std::size_t(lobes[v]), host = std::size_t(main[std::size_t(pieces[v])]);
    const bool hangs = count.size[lobe] >= smallest && count.size[lobe] < kLobeShare * count.size[host];
    if (!hangs || shareOf(lobe) >= options.lobeStrength * shareOf(host)) kept.push_back(voxels[v]);
  }
  return kept;
}

}  // namespace sonoskin
