#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// GreyWindow: which values are shown from black to white.
struct GreyWindow {
  float level = 0.5f;  // middle
  float width = 1;     // > 0

  // terms: shown = value * x + y, from 0 to 1.
  glm::vec2 terms() const { return {1 / width, 0.5f - level / width}; }
};

}  // namespace sonoskin
