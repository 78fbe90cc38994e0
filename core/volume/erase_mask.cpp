#include "core/volume/erase_mask.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace sonoskin {
namespace {

// Line: the way of a brush in the frame of the volume's axes: voxel index .* spacing, mm.
struct Line {
  glm::dvec3 from, along;
  double squaredLength;

  double squaredDistance(const glm::dvec3& position) const {
    const glm::dvec3 d = position - from;
    const double t = squaredLength > 0 ? std::clamp(glm::dot(d, along) / squaredLength, 0.0, 1.0) : 0;
    const glm::dvec3 beside = d - t * along;
    return glm::dot(beside, beside);
  }
};

}  // namespace

void append(VoxelRuns& runs, std::size_t voxel) {
  if (!runs.empty() && runs.back().first + runs.back().count == voxel) {
    ++runs.back().count;
  } else {
    runs.push_back({voxel, 1});
  }
}

VoxelRuns paint(Volume<std::uint8_t>& mask, const Brush& brush) {
  const Geometry& g = mask.geometry;
  const glm::dvec3 from = g.spacing * g.toIndex(brush.from), to = g.spacing * g.toIndex(brush.to);
  const Line line{from, to - from, glm::dot(to - from, to - from)};
  const glm::dvec3 lastIndex(g.dims - 1);
  const glm::dvec3 nearest = glm::round(to / g.spacing);
  const glm::dvec3 low = glm::min(glm::floor((glm::min(from, to) - brush.radius) / g.spacing), nearest),
                   high = glm::max(glm::ceil((glm::max(from, to) + brush.radius) / g.spacing), nearest);
  const glm::ivec3 first(glm::clamp(low, glm::dvec3(0), lastIndex + 1.0)),
      last(glm::clamp(high, glm::dvec3(-1), lastIndex));
  const std::uint8_t value = brush.mark ? 1 : 0;
  VoxelRuns changed;
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i) {
        std::uint8_t& voxel = mask.at(i, j, k);
        if ((voxel != 0) == brush.mark) continue;
        const glm::dvec3 index(i, j, k);
        if (line.squaredDistance(index * g.spacing) > brush.radius * brush.radius && index != nearest)
          continue;
        voxel = value;
        append(changed, g.index(i, j, k));
      }
  return changed;
}

void toggle(Volume<std::uint8_t>& mask, const VoxelRuns& runs) {
  for (const VoxelRun& run : runs)
    for (std::size_t v = run.first; v < run.first + run.count; ++v) mask.data[v] = mask.data[v] ? 0 : 1;
}

VoxelRuns differences(const Volume<std::uint8_t>& a, const Volume<std::uint8_t>& b) {
  VoxelRuns runs;
  for (std::size_t v = 0; v < a.data.size(); ++v)
    if ((a.data[v] != 0) != (b.data[v] != 0)) append(runs, v);
  return runs;
}

RunLengths runLengths(const Volume<std::uint8_t>& mask) {
  RunLengths runs{mask.geometry.dims, {0}};
  bool marked = false;
  for (const std::uint8_t v : mask.data) {
    if ((v != 0) != marked) {
      marked = !marked;
      runs.counts.push_back(0);
    }
    ++runs.counts.back();
  }
  return runs;
}

Volume<std::uint8_t> fromRunLengths(const RunLengths& runs, const Geometry& geometry) {
  const glm::ivec3 &a = runs.dims, &b = geometry.dims;
  require(a == b, "what was erased is of a volume of {} x {} x {} voxels; this one has {} x {} x {}", a.x,
          a.y, a.z, b.x, b.y, b.z);
  Volume<std::uint8_t> mask(geometry);
  std::size_t at = 0;
  bool marked = false;
  for (const std::size_t count : runs.counts) {
    require(count <= mask.data.size() - at, "what was erased holds more voxels than the volume");
    std::fill_n(mask.data.begin() + std::ptrdiff_t(at), count, std::uint8_t(marked));
    at += count;
    marked = !marked;
  }
  require(at == mask.data.size(), "what was erased holds fewer voxels than the volume");
  return mask;
}

}  // namespace sonoskin
