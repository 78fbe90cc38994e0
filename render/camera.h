#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/mesh/mesh.h"
#include "core/volume/scan.h"

namespace sonoskin {

// Camera: a perspective camera that orbits a point. World mm.
//   forward, up  unit and orthogonal; forward is where it looks
//   distance     from the eye to the target, mm
struct Camera {
  glm::vec3 target{0};
  glm::vec3 forward{0, 1, 0};
  glm::vec3 up{0, 0, 1};
  float distance = 100;
  float fieldOfView = 24;  // vertical, degrees; narrow, as for a portrait: near things do not swell

  glm::vec3 right() const { return glm::cross(forward, up); }
  glm::vec3 eye() const { return target - distance * forward; }
  glm::mat4 view() const;
  // projection: near and far planes close around a box of the world, or around the target where it is behind.
  glm::mat4 projection(float aspect, const Box& box) const;
  // millimetresPerPixel: at the target's depth, for a picture of `height` pixels.
  float millimetresPerPixel(int height) const;

  // orbit: turns the eye about the target, to its own right and upward, radians.
  void orbit(float toRight, float upward);
  // aroundBy: the camera after a share of a whole turn to its own right about the target, 0 to 1.
  Camera aroundBy(double share) const;
  // roll: turns the picture clockwise, radians.
  void roll(float angle);
  // pan: moves what is seen by pixels to the right and upward in a picture of `height` pixels.
  void pan(glm::vec2 pixels, int height);
  void zoom(float factor) { distance /= factor; }
};

// rightOf: the unit direction to the right of one who looks along `forward` (unit) with `up` upward; where `up` is parallel
// to it or nothing, that of some upright picture.
glm::vec3 rightOf(const glm::vec3& forward, const glm::vec3& up);

// kLeastDistance: of a camera that looks at nothing but a point, mm; any object of some size has its own.
inline constexpr float kLeastDistance = 1e-6f;

// lookAlong: a camera that sees the whole box, looking along `forward`.
//   up      any vector, see rightOf
//   aspect  width / height of the picture
Camera lookAlong(const glm::vec3& forward, const glm::vec3& up, const Box& box, float aspect);

// lookAtAll: the nearest camera that sees all points, with a small margin.
//   up       any vector, see rightOf
//   points   world mm; not empty
//   aspect   width / height of the picture
Camera lookAtAll(const glm::vec3& forward, const glm::vec3& up, std::span<const glm::vec3> points,
                 float aspect);

// parseCamera: a camera that sees the whole box, from words.
//   text    comma-separated: one of the presets, or nothing (probe), then changes to it
//           probe      along the middle beam, with the beam's upward direction
//           front, back, left, right, top, bottom   of the patient (LPS)
//           portrait   y up, seen from +z, as modelling programs have it
//           face       `face`; as probe where there is none
//           azimuth=   degrees to the camera's right        elevation=  degrees upward
//           roll=      degrees clockwise                    zoom=       factor
//           target=    x:y:z, mm    forward=, up=  directions    distance=  mm: a camera that somebody has dragged
//   errors  Error (usage): an unknown word, not a number, zoom or distance <= 0, directions that are none
Camera parseCamera(std::string_view text, const Beam& beam, const Box& box, float aspect,
                   const Camera* face = nullptr);

// cameraWords: the words of exactly this camera: "target=1:2:3,forward=0:1:0,up=0:0:1,distance=250".
std::string cameraWords(const Camera& camera);

// worldBox: the axis-aligned box around a volume, from the outer voxels' centres.
Box worldBox(const Geometry& geometry);

}  // namespace sonoskin
