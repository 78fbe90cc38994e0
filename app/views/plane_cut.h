#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "render/clip_plane.h"

namespace sonoskin::ui {

// cutCorners: where a plane cuts the edges of a box, in order around the cut; nothing where it misses the box.
//   corners  of the box: bits 1, 2, 4 of a corner's number say at which end of each of its axes it lies
std::vector<glm::vec3> cutCorners(const std::array<glm::vec3, 8>& corners, const ClipPlane& plane);

}  // namespace sonoskin::ui
