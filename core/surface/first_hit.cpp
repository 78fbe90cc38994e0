#include "core/surface/first_hit.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel_blocks.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

constexpr std::size_t kVoxelsPerTask = 512;

// BackwardLook: from surface voxels back to the probe.
class BackwardLook {
 public:
  BackwardLook(const std::vector<SurfaceVoxel>& voxels, const Volume<float>& lowPassed,
               const ScanFrame& frame, const FluidLevels& levels, double depth)
      : lowPassed_(lowPassed),
        region_(frame.region),
        beams_(frame.beam, lowPassed.geometry),
        levels_(levels),
        spacing_(lowPassed.geometry.spacing),
        step_(0.5f * float(lowPassed.geometry.minSpacing())),
        steps_(int(depth / double(step_))),
        occupied_(lowPassed.geometry.voxels(), false) {
    for (const SurfaceVoxel& v : voxels) occupied_[indexOf(v.voxel)] = true;
  }

  // isHidden: whether another surface lies before the voxel, with no fluid between.
  bool isHidden(const SurfaceVoxel& from) const {
    const glm::vec3 start = from.position * spacing_;
    const glm::vec3 back = -step_ * glm::normalize(beams_.towards(start));
    enum { onSurface, inDark, inTissue } place = onSurface;
    for (int s = 1; s <= steps_; ++s) {
      const glm::vec3 at = (start + float(s) * back) / spacing_;
      if (!isInside(at)) return false;
      const float value = greyAt(at);
      const bool tissue = value >= levels_.iso;
      if (!tissue && value < levels_.dark && place != inTissue) return false;
      if (!tissue && place == inTissue) {
        if (hasSurfaceNear(glm::ivec3(glm::round(at)))) return true;
        place = inDark;
      }
      if (place == onSurface && !tissue) place = inDark;
      if (place == inDark && tissue) place = inTissue;
    }
    return false;
  }

 private:
  std::size_t indexOf(const glm::ivec3& v) const { return lowPassed_.geometry.index(v.x, v.y, v.z); }
  bool isInside(const glm::vec3& at) const {
    return glm::all(glm::greaterThanEqual(at, glm::vec3(0))) &&
           glm::all(glm::lessThanEqual(at, glm::vec3(lowPassed_.geometry.dims - 1)));
  }
  float greyAt(const glm::vec3& at) const {
    constexpr float kFluid = -1;  // darker than any grey
    return region_.contains(glm::ivec3(glm::round(at))) ? sampleTrilinear(lowPassed_, at) : kFluid;
  }
  bool hasSurfaceNear(const glm::ivec3& middle) const {
    const glm::ivec3 low = glm::max(middle - 1, 0), high = glm::min(middle + 1, lowPassed_.geometry.dims - 1);
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          if (occupied_[indexOf({i, j, k})]) return true;
    return false;
  }

  const Volume<float>& lowPassed_;
  const Region& region_;
  LocalBeams beams_;
  FluidLevels levels_;
  glm::vec3 spacing_;
  float step_;  // mm
  int steps_;
  std::vector<bool> occupied_;
};

}  // namespace

FluidLevels findFluidLevels(const Volume<float>& lowPassed, const FieldOfView& view, double iso) {
  constexpr double kSamples = 20'000;
  const Geometry& g = lowPassed.geometry;
  const int stride = std::max(1, int(std::cbrt(double(g.voxels()) / kSamples)));
  std::vector<float> dark;
  for (int k = 0; k < g.dims.z; k += stride)
    for (int j = 0; j < g.dims.y; j += stride)
      for (int i = 0; i < g.dims.x; i += stride) {
        const float value = lowPassed.at(i, j, k);
        if (value < float(iso) && view.contains(glm::vec3(i, j, k) * glm::vec3(g.spacing)))
          dark.push_back(value);
      }
  if (dark.empty()) return {float(iso), 0};
  const auto middle = dark.begin() + std::ptrdiff_t(dark.size() / 2);
  std::nth_element(dark.begin(), middle, dark.end());
  return {float(iso), 0.5f * (*middle + float(iso))};
}

std::vector<SurfaceVoxel> keepFirstHits(const std::vector<SurfaceVoxel>& voxels,
                                        const Volume<float>& lowPassed, const ScanFrame& frame,
                                        const FluidLevels& levels, double depth, const Progress& progress) {
  if (!(depth > 0)) return voxels;
  const BackwardLook look(voxels, lowPassed, frame, levels, depth);
  std::vector<char> hidden(voxels.size());
  parallelItems(
      voxels.size(), kVoxelsPerTask, [&](std::size_t v) { hidden[v] = look.isHidden(voxels[v]); }, progress);
  std::vector<SurfaceVoxel> kept;
  for (std::size_t v = 0; v < voxels.size(); ++v)
    if (!hidden[v]) kept.push_back(voxels[v]);
  return kept;
}

}  // namespace sonoskin
