#include "core/phantom/membranes.h"

#include <optional>

#include "core/mesh/closest_point.h"
#include "core/phantom/random_field.h"

namespace sonoskin {
namespace {

using namespace sdf;

constexpr float kFar = 1000;

// wallFrom: where a look from the skin meets the wall; nothing if skin comes first, or none within 45 mm.
std::optional<vec3> wallFrom(const vec3& start, const vec3& toward, const WorldDistance& skin,
                             const WorldDistance& wall) {
  constexpr float kLeave = 2, kMost = 45, kRoot = 1.5f;
  for (float t = kLeave; t < kMost;) {
    const vec3 p = start + toward * t;
    const float d = wall(p);
    if (d < 0.05f) return p + toward * kRoot;
    const float toSkin = skin(p);
    if (t > 2 * kLeave && toSkin < 0.5f) return {};
    t += std::max(0.3f, 0.7f * std::min(d, toSkin));
  }
  return {};
}

float strand(const vec3& p, const Membrane& m) {
  constexpr float kRoot = 0.8f;  // mm thicker at the ends
  const vec3 &a = m.corners[0], &b = m.corners[1];
  const float r = 0.5f * m.thickness;
  const std::array<Joint, 4> joints{
      {{a, r + kRoot}, {glm::mix(a, b, 0.15f), r}, {glm::mix(a, b, 0.85f), r}, {b, r + kRoot}}};
  return chain(p, joints, 0.3f);
}

float sheet(const vec3& p, const Membrane& m) {
  const auto& [a, b, c, d] = m.corners;
  const vec3 first = closestPointOnTriangle(p, a, b, c).position,
             second = closestPointOnTriangle(p, a, c, d).position;
  return std::min(glm::distance(p, first), glm::distance(p, second)) - 0.5f * m.thickness;
}

}  // namespace

std::vector<Membrane> spanMembranes(const std::vector<glm::vec3>& starts,
                                    const std::vector<glm::vec3>& towards, const WorldDistance& skin,
                                    const WorldDistance& wall, std::uint32_t key) {
  std::vector<Membrane> out;
  std::uint32_t number = 0;
  for (std::size_t n = 0; n < starts.size(); ++n, ++number) {
    const bool isSheet = number % 2 == 1;
    if (isSheet && n + 1 == starts.size()) break;
    Membrane m{{}, 0.5f + uniformAt(number, key), isSheet};
    const auto end = wallFrom(starts[n], towards[n], skin, wall);
    m.corners[0] = m.corners[3] = starts[n];
    if (isSheet) m.corners[3] = starts[++n];
    const auto other = isSheet ? wallFrom(starts[n], towards[n], skin, wall) : end;
    if (!end || !other) continue;
    m.corners[1] = *end;
    m.corners[2] = *other;
    out.push_back(m);
  }
  return out;
}

float membraneDistance(const std::vector<Membrane>& membranes, const glm::vec3& p) {
  float d = kFar;
  for (const Membrane& m : membranes) d = std::min(d, m.sheet ? sheet(p, m) : strand(p, m));
  return d;
}

}  // namespace sonoskin
