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
  const glm::vec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]),
                  high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  // Limited while they are floats, which may be anything; the limits come first, for what is no number is not less.
  const auto first = [](float x, int least) {
    return int(std::ceil(std::max(float(least), x) - 0.5f - 1e-4f));
  };
  const auto last = [](float x, int most, int least) {
    return int(std::floor(std::max(float(least) - 1, std::min(float(most), x)) - 0.5f + 1e-4f));
  };
  const int x0 = first(low.x, 0), x1 = last(high.x, width, 0);
  const int y0 = first(low.y, rows[0]), y1 = last(high.y, rows[1], rows[0]);
  if (x0 > x1 || y0 > y1) return;  // most triangles that are smaller than texels: before anything is divided
  const Barycentric weights(corners);
  if (!weights.valid()) return;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const glm::vec3 w = weights.at({float(x) + 0.5f, float(y) + 0.5f});
      if (w.x >= kEdge && w.y >= kEdge && w.z >= kEdge) f(x, y, w);
    }
}

}  // namespace sonoskin
