#pragma once

#include <glm/glm.hpp>
#include <string_view>

#include "render/camera.h"
#include "render/gl/program.h"

namespace sonoskin {

// ClipPlane: half of the world: what is kept has dot(normal, place) + offset >= 0, mm; all of it where the normal is 0.
struct ClipPlane {
  glm::vec3 normal{0};
  float offset = 1;

  glm::vec4 equation() const { return {normal, offset}; }
  bool keeps(const glm::vec3& place) const { return glm::dot(normal, place) + offset >= 0; }
  friend bool operator==(const ClipPlane&, const ClipPlane&) = default;
};

// clipPlaneThrough: what lies on the side of a place to which the unit normal points is kept.
inline ClipPlane clipPlaneThrough(const glm::vec3& place, const glm::vec3& normal) {
  return {normal, -glm::dot(normal, place)};
}

// parseClip: a plane from words.
//   text    comma-separated: the side that is cut away: camera, or front, back, left, right, top, bottom of the patient (LPS),
//           and at=, mm from the middle of the box toward that side; nothing: no plane
//   errors  Error (usage): an unknown word, not a number
ClipPlane parseClip(std::string_view text, const Camera& camera, const Box& box);

// ClipInUse: while it lives, triangles that a program draws end at a plane. Its vertex shader has the uniform `clip`.
class ClipInUse {
 public:
  ClipInUse(gl::Program& program, const ClipPlane& plane);
  ~ClipInUse();
  ClipInUse(const ClipInUse&) = delete;
  ClipInUse& operator=(const ClipInUse&) = delete;
};

}  // namespace sonoskin
