#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace sonoskin {

// Barycentric: the weights of a triangle's corners at a point of the plane, linear in it.
//   signed double area zero or not finite: not valid()
struct Barycentric {
  glm::vec2 origin{0}, d1{0}, d2{0};  // the gradients of the second and third corner's weight
  float area = 0;                     // twice, positive counter-clockwise

  explicit Barycentric(const std::array<glm::vec2, 3>& c) : origin(c[0]) {
    const glm::vec2 a = c[1] - c[0], b = c[2] - c[0];
    area = a.x * b.y - a.y * b.x;
    d1 = glm::vec2(b.y, -b.x) / area;
    d2 = glm::vec2(-a.y, a.x) / area;
  }
  bool valid() const { return std::abs(area) > 1e-9f && std::abs(area) < 1e12f; }
  glm::vec3 at(const glm::vec2& p) const {
    const glm::vec2 away = p - origin;
    const float second = glm::dot(d1, away), third = glm::dot(d2, away);
    return {1 - second - third, second, third};
  }
};

// forEachTexel: calls f(x, y, weights) for every texel of `rows` whose centre lies in a triangle; texel (x, y) has its
// centre at (x + 0.5, y + 0.5). Centres on an edge belong to both triangles beside it.
//   width   texels in a row;   rows: first and one past the last
template <class F>
void forEachTexel(const std::array<glm::vec2, 3>& corners, int width, const glm::ivec2& rows, const F& f) {
  constexpr float kEdge = -1e-4f;
  const Barycentric weights(corners);
  if (!weights.valid()) return;
  const glm::vec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]),
                  high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  const auto first = [](float x) { return int(std::ceil(x - 0.5f - 1e-4f)); };
  const auto last = [](float x) { return int(std::floor(x - 0.5f + 1e-4f)); };
  const int x0 = std::max(first(low.x), 0), x1 = std::min(last(high.x), width - 1);
  const int y0 = std::max(first(low.y), rows[0]), y1 = std::min(last(high.y), rows[1] - 1);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const glm::vec3 w = weights.at({float(x) + 0.5f, float(y) + 0.5f});
      if (w.x >= kEdge && w.y >= kEdge && w.z >= kEdge) f(x, y, w);
    }
}

}  // namespace sonoskin
