#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace sonoskin {

// Packing: where boxes lie in a picture.
struct Packing {
  glm::ivec2 size{1};
  std::vector<glm::ivec2> place;  // of each box, its lower left texel
};

// packBoxes: boxes on shelves, the highest first, at least `gutter` texels from each other and from the picture's
// sides. Of several widths the one with the smallest area is taken, and among like ones the most square.
//   cost     n log n
Packing packBoxes(const std::vector<glm::ivec2>& boxes, int gutter);

}  // namespace sonoskin
