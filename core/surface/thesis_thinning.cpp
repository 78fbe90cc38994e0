#include "core/surface/thesis_thinning.h"

#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/box_blur.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

// One step of every pair of opposite neighbours.
constexpr std::array<std::array<int, 3>, 13> kDirections{{{1, 0, 0},
                                                          {0, 1, 0},
                                                          {0, 0, 1},
                                                          {1, 1, 0},
                                                          {1, -1, 0},
                                                          {1, 0, 1},
                                                          {1, 0, -1},
                                                          {0, 1, 1},
                                                          {0, 1, -1},
                                                          {1, 1, 1},
                                                          {1, 1, -1},
                                                          {1, -1, 1},
                                                          {1, -1, -1}}};

struct Context {
  const Volume<float>& blurred;
  const Volume<float>& lowPassed;
  const ScanFrame& frame;
  const SurfaceOptions& options;
  float margin;  // mm
};

bool isMaximum(const Volume<float>& u, std::size_t index) {
  const glm::vec3 gradient = gradientAt(u, glm::vec3(1), index);
  if (gradient == glm::vec3(0)) return false;
  const glm::ivec3 step = nearestOf13(gradient);
  const std::ptrdiff_t row = u.geometry.dims.x, plane = row * u.geometry.dims.y;
  const float* centre = u.data.data() + index;
  const std::ptrdiff_t offset = step.x + step.y * row + step.z * plane;
  return *centre > centre[offset] && *centre > centre[-offset];
}

// The filters that thin() has too.
bool isWanted(const Context& c, const glm::ivec3& voxel, std::size_t index) {
  const Geometry& g = c.blurred.geometry;
  if (c.frame.view.depth(glm::vec3(voxel) * glm::vec3(g.spacing)) < c.margin) return false;
  if (c.options.facing <= -1) return true;
  const glm::vec3 gradient = gradientAt(c.lowPassed, g.axisScale(), index);
  const glm::dvec3 beam = c.frame.beam.directionAt(g.toWorld(glm::dvec3(voxel)));
  const float along = glm::dot(gradient, glm::vec3(glm::transpose(g.direction) * beam));
  return along > float(c.options.facing) * glm::length(gradient);
}

}  // namespace

glm::ivec3 nearestOf13(const glm::vec3& gradient) {
  glm::ivec3 nearest(0);
  float best = -1;
  for (const auto& d : kDirections) {
    const glm::vec3 step(d[0], d[1], d[2]);
    const float cosine = std::abs(glm::dot(gradient, step)) / glm::length(step);
    if (cosine <= best) continue;
    best = cosine;
    nearest = {d[0], d[1], d[2]};
  }
  return nearest;
}

std::vector<SurfaceVoxel> thinByThesis(const Volume<float>& classified, const Volume<float>& lowPassed,
                                       const ScanFrame& frame, const SurfaceOptions& options,
                                       const Progress& progress) {
  const Geometry& g = classified.geometry;
  const Volume<float> blurred = boxBlur(classified, progress.part(0, 0.3));
  const Context context{blurred, lowPassed, frame, options, float(options.borderMargin * g.minSpacing())};
  std::vector<std::vector<SurfaceVoxel>> perSlice(std::size_t(g.dims.z));
  parallelFor(
      g.dims.z - 2,
      [&](std::ptrdiff_t inner) {
        const int k = int(inner) + 1;
        for (int j = 1; j < g.dims.y - 1; ++j)
          for (int i = 1; i < g.dims.x - 1; ++i) {
            const std::size_t index = g.index(i, j, k);
            const float value = blurred.data[index];
            if (value < float(options.threshold) || !isMaximum(blurred, index)) continue;
            if (isWanted(context, {i, j, k}, index))
              perSlice[std::size_t(k)].push_back({{i, j, k}, glm::vec3(i, j, k), value});
          }
      },
      progress.part(0.3, 1));
  std::vector<SurfaceVoxel> all;
  for (const auto& slice : perSlice) all.insert(all.end(), slice.begin(), slice.end());
  return all;
}

}  // namespace sonoskin
