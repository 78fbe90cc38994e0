#include "core/mesh/parts/split_part.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

constexpr float kBeyond = 3;  // mm that a stroke cuts beyond its ends

enum class Side : std::int8_t { unknown, left, right };

// Fan: the plane through a stroke and the eye, between the stroke's ends.
class Fan {
 public:
  explicit Fan(const Stroke& stroke) : eye_(stroke.eye) {
    const glm::vec3 a = stroke.from - eye_, b = stroke.to - eye_, n = glm::cross(a, b);
    const float length = glm::length(n);
    isPlane_ = length > 1e-6f * glm::length(a) * glm::length(b) && length > 0;
    if (!isPlane_) return;
    normal_ = n / length;
    middle_ = glm::normalize(glm::normalize(a) + glm::normalize(b));
    along_ = glm::cross(normal_, middle_);
    const float beyond = kBeyond / std::min(glm::length(a), glm::length(b));
    first_ = tangent(a) - beyond;
    last_ = tangent(b) + beyond;
  }
  bool isPlane() const { return isPlane_; }
  float height(const glm::vec3& x) const { return glm::dot(x - eye_, normal_); }
  bool holds(const glm::vec3& x) const {
    const glm::vec3 d = x - eye_;
    if (glm::dot(d, middle_) <= 0) return false;
    return tangent(d) >= first_ && tangent(d) <= last_;
  }

 private:
  float tangent(const glm::vec3& d) const { return glm::dot(d, along_) / glm::dot(d, middle_); }

  glm::vec3 eye_, normal_{0}, middle_{0}, along_{0};
  float first_ = 0, last_ = 0;
  bool isPlane_ = false;
};

// The sides of the part's triangles that the stroke meets, and of those beside them.
std::vector<std::uint32_t> markStroke(const Facets& facets, const std::vector<std::uint32_t>& part,
                                      std::uint32_t which, const Fan& fan, std::vector<Side>& side) {
  std::vector<std::uint32_t> marked;
  for (std::uint32_t t = 0; t < facets.size(); ++t) {
    if (part[t] != which || !fan.holds(facets.centre[t])) continue;
    int above = 0;
    for (const std::uint32_t v : facets.mesh.triangles[t]) above += fan.height(facets.mesh.positions[v]) > 0;
    if (above == 0 || above == 3) continue;
    side[t] = fan.height(facets.centre[t]) > 0 ? Side::left : Side::right;
    marked.push_back(t);
  }
  return marked;
}

// Spreads the sides over the rest of the part, ring by ring.
void spread(const Facets& facets, const std::vector<std::uint32_t>& part, std::uint32_t which,
            std::vector<std::uint32_t> queue, std::vector<Side>& side, const Fan& fan) {
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::uint32_t t = queue[next];
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      if (facets.opposite[h] == kNoHalfEdge) continue;
      const std::uint32_t other = facets.opposite[h] / 3;
      if (part[other] != which || side[other] != Side::unknown) continue;
      // Beside the stroke the plane decides, for a triangle on it may touch both sides.
      const bool beside = fan.holds(facets.centre[other]) && std::abs(fan.height(facets.centre[other])) < 1;
      const Side own = fan.height(facets.centre[other]) > 0 ? Side::left : Side::right;
      side[other] = beside ? own : side[t];
      queue.push_back(other);
    }
  }
}

}  // namespace

bool splitPart(const Mesh& mesh, SurfaceParts& parts, const Stroke& stroke) {
  const Fan fan(stroke);
  if (mesh.empty() || !fan.isPlane()) return false;
  const Facets facets(mesh);
  const std::uint32_t which = partAt(mesh, parts, stroke.from), fresh = std::uint32_t(parts.parts.size());
  std::vector<Side> side(facets.size(), Side::unknown);
  const std::vector<std::uint32_t> marked = markStroke(facets, parts.ofTriangle, which, fan, side);
  spread(facets, parts.ofTriangle, which, marked, side, fan);
  const auto isOn = [&](std::size_t t, Side s) { return parts.ofTriangle[t] == which && side[t] == s; };
  std::size_t left = 0, right = 0;
  for (std::size_t t = 0; t < facets.size(); ++t) left += isOn(t, Side::left), right += isOn(t, Side::right);
  if (left == 0 || right == 0) return false;
  for (std::size_t t = 0; t < facets.size(); ++t)
    if (isOn(t, Side::right)) parts.ofTriangle[t] = fresh;
  describeParts(facets, parts);
  return true;
}

std::uint32_t partAt(const Mesh& mesh, const SurfaceParts& parts, const glm::vec3& place) {
  return parts.ofTriangle[triangleNearest(mesh, place)];
}

}  // namespace sonoskin
