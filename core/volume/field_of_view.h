#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/volume/scan.h"

namespace sonoskin {

// FieldOfView: the scanned region, as the planes that bound it away from the probe's own side.
//   sides   plane normals, outward, in index space scaled to mm (index .* spacing); distance at w
struct FieldOfView {
  std::vector<glm::vec4> sides;

  // depth: mm from the nearest side plane, positive inside.
  //   position  voxel index .* spacing
  float depth(const glm::vec3& position) const {
    float least = 1e30f;
    for (const glm::vec4& side : sides)
      least = std::min(least, -(glm::dot(glm::vec3(side), position) + side.w));
    return least;
  }
};

// findFieldOfView: the convex hull of the voxels that are not zero, for scan converters put zeros outside the
// sector. Sides that look back at the probe are left out: there the hull lies on the anatomy, not on a cut.
//   method  quickhull (qhull) of the first and last non-zero voxel of every row
//   output  no sides for a volume that is zero or flat
//   errors  Cancelled
FieldOfView findFieldOfView(const Volume<float>& volume, const Beam& beam, const Progress& progress = {});

}  // namespace sonoskin
