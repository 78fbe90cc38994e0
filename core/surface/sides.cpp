#include "core/surface/sides.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

// Path: the shortest one so far from a voxel of `kept` to one of `others`.
struct Path {
  float length;  // mm
  std::size_t voxel;
  bool operator>(const Path& other) const { return length > other.length; }
};

// The 26 steps to neighbours and their lengths, mm.
struct Step {
  glm::ivec3 by;
  float length;
};
std::vector<Step> stepsOf(const Geometry& geometry) {
  std::vector<Step> steps;
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i)
        if (i || j || k)
          steps.push_back({{i, j, k}, float(glm::length(glm::dvec3(i, j, k) * geometry.spacing))});
  return steps;
}

constexpr float kTurnedAway =
    -0.2f;                     // cosine between beam and inward gradient below which the inside is seen
constexpr float kBehind = 30;  // mm behind what faces the probe within which its other sides lie
constexpr std::size_t kVoxelsPerTask = 256;

// Fronts: where voxels lie that face the probe, each with those around it, so that small gaps do not count.
class Fronts {
 public:
  Fronts(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry, const Beam& beam)
      : geometry_(geometry), beams_(beam, geometry), isFront_(geometry.voxels(), false) {
    constexpr int kAround = 2;
    for (const SurfaceVoxel& v : voxels)
      if (v.facing > 0) {
        const glm::ivec3 low = glm::max(v.voxel - kAround, 0);
        const glm::ivec3 high = glm::min(v.voxel + kAround, geometry.dims - 1);
        for (int k = low.z; k <= high.z; ++k)
          for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) isFront_[geometry.index(i, j, k)] = true;
      }
  }

  bool liesBefore(const SurfaceVoxel& from) const {
    const glm::vec3 spacing(geometry_.spacing), start = from.position * spacing;
    const float step = float(geometry_.minSpacing());
    const glm::vec3 back = -step * glm::normalize(beams_.towards(start));
    for (int s = 1; float(s) * step < kBehind; ++s) {
      const glm::ivec3 at(glm::round((start + float(s) * back) / spacing));
      if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, geometry_.dims)))
        return false;
      if (isFront_[geometry_.index(at.x, at.y, at.z)]) return true;
    }
    return false;
  }

 private:
  const Geometry& geometry_;
  LocalBeams beams_;
  std::vector<bool> isFront_;
};

}  // namespace

std::vector<SurfaceVoxel> growSides(const std::vector<SurfaceVoxel>& kept,
                                    const std::vector<SurfaceVoxel>& others, const Geometry& geometry,
                                    double reach) {
  if (!(reach > 0) || others.empty()) return kept;
  const auto indexOf = [&](const glm::ivec3& v) { return geometry.index(v.x, v.y, v.z); };
  std::unordered_map<std::size_t, std::size_t> at;  // voxel of the volume -> one of `others`
  at.reserve(others.size());
  for (std::size_t o = 0; o < others.size(); ++o) at.emplace(indexOf(others[o].voxel), o);
  const std::vector<Step> steps = stepsOf(geometry);
  std::vector<float> length(others.size(), std::numeric_limits<float>::infinity());
  std::priority_queue<Path, std::vector<Path>, std::greater<>> paths;
  const auto relax = [&](const glm::ivec3& from, float soFar) {
    for (const Step& step : steps) {
      const auto found = at.find(indexOf(from + step.by));
      const float there = soFar + step.length;
      if (found == at.end() || there > float(reach) || there >= length[found->second]) continue;
      length[found->second] = there;
      paths.push({there, found->second});
    }
  };
  for (const SurfaceVoxel& v : kept) relax(v.voxel, 0);
  while (!paths.empty()) {
    const Path path = paths.top();
    paths.pop();
    if (path.length <= length[path.voxel]) relax(others[path.voxel].voxel, path.length);
  }
  std::vector<SurfaceVoxel> grown = kept;
  for (std::size_t o = 0; o < others.size(); ++o)
    if (length[o] <= float(reach)) grown.push_back(others[o]);
  std::ranges::sort(grown, {}, [&](const SurfaceVoxel& v) { return indexOf(v.voxel); });
  return grown;
}

std::vector<SurfaceVoxel> dropBareSides(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                        const Beam& beam, const Progress& progress) {
  const Fronts fronts(voxels, geometry, beam);
  std::vector<char> bare(voxels.size(), 0);
  parallelItems(
      voxels.size(), kVoxelsPerTask,
      [&](std::size_t v) { bare[v] = voxels[v].facing < kTurnedAway && !fronts.liesBefore(voxels[v]); },
      progress);
  std::vector<SurfaceVoxel> kept;
  for (std::size_t v = 0; v < voxels.size(); ++v)
    if (!bare[v]) kept.push_back(voxels[v]);
  return kept;
}

}  // namespace sonoskin
