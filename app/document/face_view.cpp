#include "app/document/face_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sonoskin {
namespace {

using glm::vec3;

vec3 forwardOf(const FaceFit* face, const vec3& beam) {
  if (!face) return beam;
  constexpr float kMost = 0.2094f;  // 12 degrees
  const float angle = std::acos(std::clamp(glm::dot(-face->front, beam), -1.f, 1.f));
  if (angle <= kMost) return -face->front;
  const float sine = std::sin(angle);
  if (sine < 1e-3f) return beam;
  return glm::normalize((std::sin(angle - kMost) * beam - std::sin(kMost) * face->front) / sine);
}

// The head's own points, without what lies around it; all where the face is not known, or none is near.
std::vector<vec3> shownPoints(std::span<const vec3> points, const FaceFit* face) {
  std::vector<vec3> shown;
  if (face) {
    const vec3 middle = face->placement.toWorld(vec3(0, 2, 12));
    // A face may be longer than the model's, with its mouth open.
    const float radius = std::max(0.62f * face->headHeight, 1.3f * glm::distance(middle, face->places.chin));
    std::copy_if(points.begin(), points.end(), std::back_inserter(shown),
                 [&](const vec3& p) { return glm::distance(p, middle) < radius; });
  }
  if (shown.empty()) shown.assign(points.begin(), points.end());
  return shown;
}

vec3 upOf(const FaceFit* face, const Beam& beam) { return face ? face->up : vec3(beam.up); }

}  // namespace

Camera cameraOnFace(std::span<const vec3> points, const FaceFit* face, const Beam& beam, float aspect) {
  return lookAtAll(forwardOf(face, vec3(beam.axis)), upOf(face, beam), shownPoints(points, face), aspect);
}

bool isTall(std::span<const vec3> points, const FaceFit* face, const Beam& beam) {
  const vec3 forward = forwardOf(face, vec3(beam.axis));
  const vec3 right = rightOf(forward, upOf(face, beam)), up = glm::cross(right, forward);
  glm::vec2 low(1e30f), high(-1e30f);
  for (const vec3& p : shownPoints(points, face)) {
    const glm::vec2 at(glm::dot(p, right), glm::dot(p, up));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const glm::vec2 size = high - low;
  return size.y > 1.1f * size.x;
}

}  // namespace sonoskin
