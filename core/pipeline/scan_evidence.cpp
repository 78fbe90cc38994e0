#include "core/pipeline/scan_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

constexpr double kVoxels = 230'000;     // about so many are looked at, evenly spread
constexpr std::size_t kPoints = 4'000;  // and so many points
constexpr float kMargin = 6;            // voxels from the view's border, whose edge the low-pass blurs
constexpr double kEdgeShare = 0.04;     // of the voxels the steepest count as edges
constexpr float kSideways =
    0.5f;                      // cosine to the beam: half of all directions lie between this and its negative
constexpr float kNearest = 2;  // mm before a point from where fluid is looked for, and at least
constexpr float kNearestVoxels = 2;  // so many smallest spacings: beyond the echo's flank
constexpr float kAlong = 6;          // mm: for so long
constexpr float kStep = 0.5f;        // mm
constexpr float kFluidShare = 0.4f;  // of that way which must be fluid
constexpr double kJoined = 2.5;      // smallest spacings: cells of the surface that touch are one piece

// Edge: a voxel's gradient: its length, and its cosine to the beam.
struct Edge {
  float length, cosine;
};

// VoxelSample: the voxels that were looked at.
struct VoxelSample {
  std::size_t dark = 0;
  double roughness = 0;
  std::vector<Edge> edges;  // one for each
};

// How far a voxel is from the mean of its six neighbours.
float roughnessAt(const float* v, std::ptrdiff_t row, std::ptrdiff_t plane) {
  return std::abs(*v - (v[1] + v[-1] + v[row] + v[-row] + v[plane] + v[-plane]) / 6);
}

void sampleVoxel(const EvidenceInput& in, const glm::ivec3& voxel, VoxelSample& sample) {
  const Geometry& g = in.lowPassed.geometry;
  const std::ptrdiff_t row = g.dims.x, plane = row * g.dims.y;
  const std::size_t index = g.index(voxel.x, voxel.y, voxel.z);
  const glm::vec3 gradient = gradientAt(in.lowPassed, g.axisScale(), index);
  const glm::vec3 along(glm::transpose(g.direction) * in.beam.directionAt(g.toWorld(glm::dvec3(voxel))));
  const float length = glm::length(gradient);
  sample.edges.push_back({length, length > 0 ? glm::dot(gradient, along) / length : 0});
  sample.roughness += double(roughnessAt(in.recorded.data.data() + index, row, plane));
  sample.dark += in.lowPassed.data[index] < in.levels.between(0.5);
}

VoxelSample sampleView(const EvidenceInput& in, const Progress& progress) {
  const Geometry& g = in.lowPassed.geometry;
  const int stride = std::max(1, int(std::cbrt(double(g.voxels()) / kVoxels)));
  const int slices = std::max(0, (g.dims.z - 2 + stride - 1) / stride);
  const float margin = kMargin * float(g.minSpacing());
  std::vector<VoxelSample> perSlice{std::size_t(slices)};
  parallelFor(
      slices,
      [&](std::ptrdiff_t slice) {
        const int k = 1 + int(slice) * stride;
        for (int j = 1; j < g.dims.y - 1; j += stride)
          for (int i = 1; i < g.dims.x - 1; i += stride) {
            const glm::vec3 position = glm::vec3(i, j, k) * glm::vec3(g.spacing);
            if (in.view.contains(position) && in.view.depth(position) >= margin)
              sampleVoxel(in, {i, j, k}, perSlice[std::size_t(slice)]);
          }
      },
      progress);
  VoxelSample all;
  for (const VoxelSample& some : perSlice) {  // in order, so that sums do not depend on the threads
    all.dark += some.dark;
    all.roughness += some.roughness;
    all.edges.insert(all.edges.end(), some.edges.begin(), some.edges.end());
  }
  return all;
}

// Of the steepest edges, by gradient, those across the beam.
double shareSideways(std::vector<Edge>& edges) {
  const auto steepest = edges.begin() + std::ptrdiff_t((1 - kEdgeShare) * double(edges.size()));
  std::nth_element(edges.begin(), steepest, edges.end(),
                   [](const Edge& a, const Edge& b) { return a.length < b.length; });
  double all = 0, sideways = 0;
  for (auto edge = steepest; edge != edges.end(); ++edge) {
    all += double(edge->length);
    if (std::abs(edge->cosine) < kSideways) sideways += double(edge->length);
  }
  return all > 0 ? sideways / all : 0;
}

void weighVoxels(const EvidenceInput& in, ScanEvidence& evidence, const Progress& progress) {
  VoxelSample sample = sampleView(in, progress);
  if (sample.edges.empty()) return;
  const double count = double(sample.edges.size());
  evidence.hasEdges = std::ranges::any_of(sample.edges, [](const Edge& e) { return e.length > 0; });
  evidence.noise = sample.roughness / count;
  evidence.dark = double(sample.dark) / count;
  evidence.sideways = shareSideways(sample.edges);
}

// The share of points with fluid close before them, of those with anything recorded there.
double shareClear(const EvidenceInput& in) {
  const Geometry& g = in.lowPassed.geometry;
  const float dark = in.levels.between(0.5);
  const float nearest = std::max(kNearest, kNearestVoxels * float(g.minSpacing()));
  const std::size_t count = in.points.size(), stride = std::max<std::size_t>(1, count / kPoints);
  std::size_t known = 0, clear = 0;
  for (std::size_t p = 0; p < count; p += stride) {
    const glm::dvec3 at(in.points.positions[p]);
    const glm::vec3 start(g.toIndex(at));
    const glm::vec3 step =
        glm::vec3(glm::transpose(g.direction) * in.beam.directionAt(at)) / glm::vec3(g.spacing);
    int seen = 0, fluid = 0;
    for (float before = nearest; before <= nearest + kAlong; before += kStep) {
      const glm::vec3 place = start - before * step;
      if (!in.view.contains(place * glm::vec3(g.spacing))) break;
      ++seen;
      fluid += sampleTrilinear(in.lowPassed, place) < dark;
    }
    known += seen > 0;
    clear += seen > 0 && float(fluid) >= kFluidShare * float(seen);
  }
  return known > 0 ? double(clear) / double(known) : 1;
}

// Pieces: cells that hold points, joined where they touch, also at a corner.
class Pieces {
 public:
  explicit Pieces(std::vector<std::array<int, 3>> cells)
      : ofPoint_(std::move(cells)), cells_(ofPoint_), sets_(cells_.size()) {
    std::ranges::sort(cells_);
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    for (std::size_t c = 0; c < cells_.size(); ++c) joinNeighbours(c);
  }

  // The share of the points in the piece with most of them.
  double largest() {
    std::vector<std::size_t> points(cells_.size());
    std::size_t most = 0;
    for (const auto& cell : ofPoint_) {
      const auto at = std::ranges::lower_bound(cells_, cell);
      most = std::max(most, ++points[sets_.root(std::uint32_t(at - cells_.begin()))]);
    }
    return double(most) / double(ofPoint_.size());
  }

 private:
  void joinNeighbours(std::size_t c) {
    const std::array<int, 3> cell = cells_[c];
    for (int n = 14; n < 27; ++n) {  // each pair once
      const std::array<int, 3> other{cell[0] + n / 9 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n % 3 - 1};
      const auto at = std::ranges::lower_bound(cells_, other);
      if (at != cells_.end() && *at == other)
        sets_.join(std::uint32_t(c), std::uint32_t(at - cells_.begin()));
    }
  }

  std::vector<std::array<int, 3>> ofPoint_, cells_;
  DisjointSets sets_;
};

double shareOfLargest(const SurfacePoints& points, double cell) {
  std::vector<std::array<int, 3>> cells;
  cells.reserve(points.size());
  for (const glm::vec3& p : points.positions) {
    const glm::ivec3 c(glm::floor(glm::dvec3(p) / cell));
    cells.push_back({c.x, c.y, c.z});
  }
  return Pieces(std::move(cells)).largest();
}

}  // namespace

ScanEvidence weighEvidence(const EvidenceInput& input, const Progress& progress) {
  ScanEvidence evidence;
  weighVoxels(input, evidence, progress.part(0, 0.8));
  if (input.points.size() > 0) {
    evidence.clear = shareClear(input);
    evidence.largest = shareOfLargest(input.points, kJoined * input.lowPassed.geometry.minSpacing());
  }
  if (input.edge.width > 0) {
    evidence.rise = input.edge.bright - input.edge.dark;
    evidence.width = input.edge.width;
  }
  progress.update(1);
  return evidence;
}

}  // namespace sonoskin
