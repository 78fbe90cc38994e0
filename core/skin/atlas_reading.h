#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/atlas.h"

namespace sonoskin {

// readAtlas: a map of colours, premultiplied by their coverage, between its texels; black where nothing is.
//   place   in texels from the lower left corner of texel (0,0)
inline glm::vec3 readAtlas(const std::vector<glm::vec4>& map, const glm::ivec2& size,
                           const glm::vec2& place) {
  const glm::vec2 middle = glm::clamp(place - 0.5f, glm::vec2(0), glm::vec2(size - 1));
  const glm::ivec2 low(middle), high = glm::min(low + 1, size - 1);
  const glm::vec2 part = middle - glm::vec2(low);
  const auto at = [&](int x, int y) { return map[std::size_t(y) * std::size_t(size.x) + std::size_t(x)]; };
  const glm::vec4 sum = glm::mix(glm::mix(at(low.x, low.y), at(high.x, low.y), part.x),
                                 glm::mix(at(low.x, high.y), at(high.x, high.y), part.x), part.y);
  return sum.a > 0 ? glm::vec3(sum) / sum.a : glm::vec3(0);
}

// placeInAtlas: where the weights of a triangle's corners lead.
inline glm::vec2 placeInAtlas(const Corners& corners, const glm::vec3& weights) {
  return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

}  // namespace sonoskin
