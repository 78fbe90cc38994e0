#include "core/surface/sides.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

namespace sonoskin {
namespace {

// Way: to a voxel of `others`, or to one of `kept` where the ways begin.
struct Way {
  float length;  // mm
  std::size_t voxel;
  bool operator>(const Way& other) const { return length > other.length; }
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
  std::priority_queue<Way, std::vector<Way>, std::greater<>> ways;
  const auto goOn = [&](const glm::ivec3& from, float soFar) {
    for (const Step& step : steps) {
      const auto found = at.find(indexOf(from + step.by));
      const float there = soFar + step.length;
      if (found == at.end() || there > float(reach) || there >= length[found->second]) continue;
      length[found->second] = there;
      ways.push({there, found->second});
    }
  };
  for (const SurfaceVoxel& v : kept) goOn(v.voxel, 0);
  while (!ways.empty()) {
    const Way way = ways.top();
    ways.pop();
    if (way.length <= length[way.voxel]) goOn(others[way.voxel].voxel, way.length);
  }
  std::vector<SurfaceVoxel> grown = kept;
  for (std::size_t o = 0; o < others.size(); ++o)
    if (length[o] <= float(reach)) grown.push_back(others[o]);
  std::ranges::sort(grown, {}, [&](const SurfaceVoxel& v) { return indexOf(v.voxel); });
  return grown;
}

}  // namespace sonoskin
