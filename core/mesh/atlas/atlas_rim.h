#pragma once

#include "core/mesh/atlas/atlas_bands.h"
#include "core/mesh/facets.h"

namespace sonoskin {

// RimSide: a side of a triangle beyond which its chart ends.
struct RimSide {
  std::uint32_t triangle, corner;  // it runs from this corner to the next
};

// rimSides: those at borders of the surface and at seams.
std::vector<RimSide> rimSides(const Facets& facets, const Atlas& atlas);

// forEachRimTexel: calls f(x, y, distance, weights) for the texels of `rows` whose centre lies within kRimReach texels of a
// side, on the other side than the triangle.
//   weights   barycentric: those of the nearest point of the side
inline constexpr float kRimReach = 1.42f;  // what looking up between texels may touch; gutters stay open
template <class F>
void forEachRimTexel(const Corners& corners, std::uint32_t corner, int width, const glm::ivec2& rows,
                     const F& f) {
  const glm::vec2 &from = corners[corner], &to = corners[(corner + 1) % 3];
  const glm::vec2 low = glm::min(from, to) - kRimReach, high = glm::max(from, to) + kRimReach,
                  way = to - from;
  const float length2 = glm::dot(way, way);
  const int x0 = std::max(int(low.x), 0), x1 = std::min(int(high.x), width - 1);
  const int y0 = std::max(int(low.y), rows[0]), y1 = std::min(int(high.y), rows[1] - 1);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const glm::vec2 centre(float(x) + 0.5f, float(y) + 0.5f);
      const float along = length2 > 0 ? std::clamp(glm::dot(centre - from, way) / length2, 0.f, 1.f) : 0.f;
      const float distance = glm::length(from + along * way - centre);
      if (distance > kRimReach) continue;
      glm::vec3 weights(0);
      weights[int(corner)] = 1 - along;
      weights[int((corner + 1) % 3)] = along;
      f(x, y, distance, weights);
    }
}

}  // namespace sonoskin
