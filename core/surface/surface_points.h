#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace sonoskin {

// SurfacePoints: an oriented point cloud on the skin. World mm, LPS.
//   normals      unit, outward: toward the dark side (the fluid, the probe)
//   confidence   > 0, at most 1: the classified value at the point
// All three have the same length.
struct SurfacePoints {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<float> confidence;

  std::size_t size() const { return positions.size(); }
};

}  // namespace sonoskin
