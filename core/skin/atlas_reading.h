#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/atlas/atlas.h"

namespace sonoskin {

// AtlasLook: the four texels between which a map is read, and their shares, which add up to 1.
struct AtlasLook {
  std::array<std::uint32_t, 4> texels;
  glm::vec4 shares;
};

// lookBetween: at a place in texels from the lower left corner of texel (0,0).
inline AtlasLook lookBetween(const glm::ivec2& size, const glm::vec2& place) {
  const glm::vec2 middle = glm::clamp(place - 0.5f, glm::vec2(0), glm::vec2(size - 1));
  const glm::ivec2 low(middle), high = glm::min(low + 1, size - 1);
  const glm::vec2 part = middle - glm::vec2(low), rest = 1.f - part;
  const auto at = [&](int x, int y) { return std::uint32_t(y) * std::uint32_t(size.x) + std::uint32_t(x); };
  return {{at(low.x, low.y), at(high.x, low.y), at(low.x, high.y), at(high.x, high.y)},
          {rest.x * rest.y, part.x * rest.y, rest.x * part.y, part.x * part.y}};
}

// readAtlas: a map of colours, premultiplied by their coverage, between its texels; black where nothing is.
inline glm::vec3 readAtlas(const std::vector<glm::vec4>& map, const glm::ivec2& size,
                           const glm::vec2& place) {
  const AtlasLook look = lookBetween(size, place);
  glm::vec4 sum(0);
  for (int k = 0; k < 4; ++k) sum += look.shares[k] * map[look.texels[std::size_t(k)]];
  return sum.a > 0 ? glm::vec3(sum) / sum.a : glm::vec3(0);
}

// placeInAtlas: where the weights of a triangle's corners lead.
inline glm::vec2 placeInAtlas(const Corners& corners, const glm::vec3& weights) {
  return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

}  // namespace sonoskin
