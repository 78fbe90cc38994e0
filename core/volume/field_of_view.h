#pragma once

#include <algorithm>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/scan.h"

namespace sonoskin {

// FieldOfView: the scanned region as a convex polyhedron. Positions are voxel index .* spacing, mm.
//   sides   planes that bound it beside and beyond the anatomy: outward unit normal, offset at w
//   front   planes that look back at the probe: there the hull lies on the anatomy, not on a cut
struct FieldOfView {
  std::vector<glm::vec4> sides, front;

  // depth: mm from the nearest side plane, positive inside; large where there are none.
  float depth(const glm::vec3& position) const { return depthBehind(sides, position); }
  bool contains(const glm::vec3& position) const {
    return depthBehind(sides, position) >= 0 && depthBehind(front, position) >= 0;
  }

 private:
  static float depthBehind(const std::vector<glm::vec4>& planes, const glm::vec3& position) {
    float least = 1e30f;
    for (const glm::vec4& p : planes) least = std::min(least, -(glm::dot(glm::vec3(p), position) + p.w));
    return least;
  }
};

// findFieldOfView: the convex hull of the voxels that are not zero, for scan converters put zeros outside the
// sector.
//   method  quickhull (qhull) of the first and last non-zero voxel of every row
//   output  no planes for a volume that is zero or flat
//   errors  Cancelled
FieldOfView findFieldOfView(const Volume<float>& volume, const Beam& beam, const Progress& progress = {});

}  // namespace sonoskin
