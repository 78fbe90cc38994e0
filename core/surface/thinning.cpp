#include "core/surface/thinning.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

// What the test of one voxel needs, gathered once.
struct Context {
  const Volume<float>& u;
  const Volume<float>& lowPassed;
  ScanFrame frame;
  SurfaceOptions options;
  glm::vec3 axisScale;
  glm::vec3 spacing;
  float margin;  // mm
};

// Whether the surface at a voxel with this gradient (per mm along i, j, k) faces the probe.
bool facesProbe(const Context& c, const glm::ivec3& voxel, const glm::vec3& gradient) {
  if (c.options.facing <= -1) return true;
  const Geometry& g = c.u.geometry;
  const glm::dvec3 beam = c.frame.beam.directionAt(g.toWorld(glm::dvec3(voxel)));
  const float along = glm::dot(gradient, glm::vec3(glm::transpose(g.direction) * beam));
  return along > float(c.options.facing) * glm::length(gradient);
}

// Where the ridge lies between the neighbours at -1 and 1. Across a surface u is a Lorentzian, gamma h uind /
// (alpha a + gamma h) with a squared distance a, so 1/u is a parabola and its lowest point exact; a parabola through
// u itself would be off by up to 0.06.
float ridgeOffset(float before, float centre, float after) {
  const float low = 1e-3f;
  const float a = 1 / std::max(before, low), c = 1 / std::max(centre, low), b = 1 / std::max(after, low);
  const float curvature = a - 2 * c + b;
  return curvature > 1e-6f ? std::clamp(0.5f * (a - b) / curvature, -0.5f, 0.5f) : 0.0f;
}

// Looks at one voxel and appends it where it is a surface voxel.
void testVoxel(const Context& c, const glm::ivec3& voxel, std::vector<SurfaceVoxel>& found) {
  const std::size_t index = c.u.geometry.index(voxel.x, voxel.y, voxel.z);
  const float centre = c.u.data[index];
  const glm::vec3 gradient = gradientAt(c.lowPassed, c.axisScale, index);
  glm::vec3 step = gradient * c.axisScale;  // a step in mm along the gradient, in voxels
  const float longest = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
  if (longest < 1e-12f) return;
  step /= longest;
  const glm::vec3 here(voxel);
  const float before = sampleTrilinear(c.u, here - step), after = sampleTrilinear(c.u, here + step);
  if (!((centre > before && centre >= after) || (centre >= before && centre > after))) return;
  if (!facesProbe(c, voxel, gradient)) return;
  if (c.frame.view.depth(here * c.spacing) < c.margin) return;
  const float t = ridgeOffset(before, centre, after);
  found.push_back({voxel, here + t * step, centre});
}

}  // namespace

std::vector<SurfaceVoxel> thin(const Volume<float>& classified, const Volume<float>& lowPassed,
                               const ScanFrame& frame, const SurfaceOptions& options,
                               const Progress& progress) {
  const Geometry& g = classified.geometry;
  const Context context{classified,
                        lowPassed,
                        frame,
                        options,
                        g.axisScale(),
                        glm::vec3(g.spacing),
                        float(options.borderMargin * g.minSpacing())};
  std::vector<std::vector<SurfaceVoxel>> perSlice(std::size_t(g.dims.z));
  parallelFor(
      g.dims.z - 2,
      [&](std::ptrdiff_t inner) {
        const int k = int(inner) + 1;
        for (int j = 1; j < g.dims.y - 1; ++j) {
          const float* row = &classified.at(0, j, k);
          for (int i = 1; i < g.dims.x - 1; ++i)
            if (row[i] >= float(options.threshold)) testVoxel(context, {i, j, k}, perSlice[std::size_t(k)]);
        }
      },
      progress);
  std::vector<SurfaceVoxel> all;
  for (const auto& slice : perSlice) all.insert(all.end(), slice.begin(), slice.end());
  return all;
}

}  // namespace sonoskin
