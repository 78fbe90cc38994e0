#include "render/camera.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/error.h"
#include "core/base/perpendicular.h"

namespace sonoskin {
namespace {

struct Preset {
  std::string_view name;
  glm::vec3 forward, up;
};

// LPS: +x is the patient's left, +y the back, +z the head.
constexpr std::array<Preset, 7> kPresets{{{"front", {0, 1, 0}, {0, 0, 1}},
                                          {"back", {0, -1, 0}, {0, 0, 1}},
                                          {"left", {-1, 0, 0}, {0, 0, 1}},
                                          {"right", {1, 0, 0}, {0, 0, 1}},
                                          {"top", {0, 0, -1}, {0, -1, 0}},
                                          {"bottom", {0, 0, 1}, {0, -1, 0}},
                                          {"portrait", {0, 0, -1}, {0, 1, 0}}}};

glm::vec3 turned(const glm::vec3& v, const glm::vec3& axis, float angle) {
  return glm::vec3(glm::rotate(glm::mat4(1), angle, axis) * glm::vec4(v, 0));
}

std::array<glm::vec3, 8> corners(const Box& box) {
  std::array<glm::vec3, 8> result;
  for (int c = 0; c < 8; ++c)
    result[std::size_t(c)] = {c & 1 ? box.max.x : box.min.x, c & 2 ? box.max.y : box.min.y,
                              c & 4 ? box.max.z : box.min.z};
  return result;
}

[[noreturn]] void refuse(std::string_view word) {
  throw Error(
      fmt::format(
          "--camera: \"{}\" is not known; use probe, front, back, left, right, top, bottom or portrait, "
          "then azimuth=, elevation=, roll= (degrees) or zoom=, or target=, forward=, up= (x:y:z) and "
          "distance=",
          word),
      Error::Kind::usage);
}

std::optional<float> numberIn(std::string_view text) {
  float value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

// "1:-2.5:3"
std::optional<glm::vec3> vectorIn(std::string_view text) {
  glm::vec3 vector(0);
  for (int i = 0; i < 3; ++i) {
    const auto end = i < 2 ? text.find(':') : text.size();
    if (end == std::string_view::npos) return {};
    const auto number = numberIn(text.substr(0, end));
    if (!number) return {};
    vector[i] = *number;
    text.remove_prefix(i < 2 ? end + 1 : end);
  }
  return vector;
}

// applyPose: "target=1:2:3", "forward=0:1:0" and "up=0:0:1"; whether it is one of these.
bool applyPose(std::string_view name, std::string_view text, Camera& camera) {
  constexpr float kShortest = 1e-3f;  // of a direction
  const auto vector = vectorIn(text);
  if (!vector) return false;
  const bool directs = glm::length(*vector) > kShortest;
  if (name == "target") {
    camera.target = *vector;
  } else if (name == "forward" && directs) {
    camera.forward = glm::normalize(*vector);
    camera.up = glm::cross(rightOf(camera.forward, camera.up), camera.forward);
  } else if (name == "up" && directs) {
    camera.up = glm::cross(rightOf(camera.forward, glm::normalize(*vector)), camera.forward);
  } else {
    return false;
  }
  return true;
}

// applyChange: "azimuth=30" and the like.
void applyChange(std::string_view word, Camera& camera) {
  const auto equals = word.find('=');
  if (equals == std::string_view::npos) refuse(word);
  const auto name = word.substr(0, equals), number = word.substr(equals + 1);
  if (applyPose(name, number, camera)) return;
  const auto given = numberIn(number);
  if (!given) refuse(word);
  const float value = *given;
  const float angle = glm::radians(value);
  if (name == "azimuth")
    camera.orbit(angle, 0);
  else if (name == "elevation")
    camera.orbit(0, angle);
  else if (name == "roll")
    camera.roll(angle);
  else if (name == "zoom" && value > 0)
    camera.zoom(value);
  else if (name == "distance" && value > 0)
    camera.distance = value;
  else
    refuse(word);
}

// presetCamera: the camera of a preset's name; nothing where the word is none.
bool presetCamera(std::string_view word, const Beam& beam, const Box& box, float aspect, const Camera* face,
                  Camera& camera) {
  if (word == "face" && face) {
    camera = *face;
    return true;
  }
  if (word == "probe" || word == "face") {
    camera = lookAlong(glm::vec3(beam.axis), glm::vec3(beam.up), box, aspect);
    return true;
  }
  for (const auto& preset : kPresets)
    if (preset.name == word) {
      camera = lookAlong(preset.forward, preset.up, box, aspect);
      return true;
    }
  return false;
}

}  // namespace

glm::mat4 Camera::view() const { return glm::lookAt(eye(), target, up); }

glm::mat4 Camera::projection(float aspect, const Box& box) const {
  float nearest = 1e30f, farthest = -1e30f;
  for (const auto& corner : corners(box)) {
    const float depth = glm::dot(corner - eye(), forward);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  farthest = std::max(farthest * 1.01f, 0.02f * distance);
  nearest = std::max(nearest * 0.99f, std::max(0.01f * distance, 0.001f * farthest));
  return glm::perspective(glm::radians(fieldOfView), aspect, nearest, std::max(farthest, 1.01f * nearest));
}

float Camera::millimetresPerPixel(int height) const {
  return 2 * distance * std::tan(0.5f * glm::radians(fieldOfView)) / float(height);
}

void Camera::orbit(float toRight, float upward) {
  forward = glm::normalize(turned(forward, up, toRight));
  const glm::vec3 axis = right();
  forward = glm::normalize(turned(forward, axis, -upward));
  up = glm::normalize(glm::cross(axis, forward));
}

Camera Camera::aroundBy(double share) const {
  Camera other = *this;
  other.orbit(float(2 * 3.14159265358979 * share), 0);
  return other;
}

void Camera::roll(float angle) { up = glm::normalize(turned(up, forward, -angle)); }

void Camera::pan(glm::vec2 pixels, int height) {
  const glm::vec2 mm = pixels * millimetresPerPixel(height);
  target -= mm.x * right() + mm.y * up;
}

glm::vec3 rightOf(const glm::vec3& forward, const glm::vec3& up) {
  constexpr float kParallel = 1e-6f;
  const glm::vec3 across = glm::cross(forward, up);
  const float length = glm::length(across);
  if (length > kParallel * glm::length(up) && std::isfinite(length)) return across / length;
  return perpendicularTo<1, 2>(forward);
}

Camera lookAlong(const glm::vec3& forward, const glm::vec3& up, const Box& box, float aspect) {
  Camera camera;
  camera.target = box.centre();
  camera.forward = glm::normalize(forward);
  const glm::vec3 right = rightOf(camera.forward, up);
  camera.up = glm::cross(right, camera.forward);
  // Every corner must lie inside the four side planes: distance >= |offset| / tangent - depth beyond the
  // target.
  const float tangent = std::tan(0.5f * glm::radians(camera.fieldOfView));
  camera.distance = kLeastDistance;
  for (const auto& corner : corners(box)) {
    const glm::vec3 d = corner - camera.target;
    const float sideways = std::max(std::abs(glm::dot(d, right)) / aspect, std::abs(glm::dot(d, camera.up)));
    camera.distance = std::max(camera.distance, 1.04f * sideways / tangent - glm::dot(d, camera.forward));
  }
  return camera;
}

// Each point asks of the distance D: |x - t| <= (D + depth) tan, with t where the picture's middle is.
Camera lookAtAll(const glm::vec3& forward, const glm::vec3& up, std::span<const glm::vec3> points,
                 float aspect) {
  constexpr float kMargin = 1.04f;
  Camera camera;
  camera.forward = glm::normalize(forward);
  const glm::vec3 right = rightOf(camera.forward, up);
  camera.up = glm::cross(right, camera.forward);
  const float high = std::tan(0.5f * glm::radians(camera.fieldOfView)) / kMargin, wide = aspect * high;
  glm::vec4 most(-1e30f);  // to the right, left, top, bottom
  glm::vec3 middle(0);
  for (const glm::vec3& p : points) middle += p / float(points.size());
  for (const glm::vec3& p : points) {
    const glm::vec3 q = p - middle;
    const float x = glm::dot(q, right) / wide, y = glm::dot(q, camera.up) / high;
    most = glm::max(most, glm::vec4(x, -x, y, -y) - glm::dot(q, camera.forward));
  }
  camera.target =
      middle + 0.5f * (most.x - most.y) * wide * right + 0.5f * (most.z - most.w) * high * camera.up;
  camera.distance = std::max(0.5f * std::max(most.x + most.y, most.z + most.w), kLeastDistance);
  return camera;
}

Camera parseCamera(std::string_view text, const Beam& beam, const Box& box, float aspect,
                   const Camera* face) {
  Camera camera = lookAlong(glm::vec3(beam.axis), glm::vec3(beam.up), box, aspect);
  bool first = true;
  while (!text.empty()) {
    const auto word = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (!(first && presetCamera(word, beam, box, aspect, face, camera))) applyChange(word, camera);
    first = false;
  }
  return camera;
}

std::string cameraWords(const Camera& camera) {
  const auto words = [](const glm::vec3& v) { return fmt::format("{}:{}:{}", v.x + 0, v.y + 0, v.z + 0); };
  return fmt::format("target={},forward={},up={},distance={}", words(camera.target), words(camera.forward),
                     words(camera.up), camera.distance);
}

Box worldBox(const Geometry& geometry) {
  const glm::dvec3 last(geometry.dims - 1);
  Box box{glm::vec3(geometry.toWorld({0, 0, 0})), glm::vec3(geometry.toWorld({0, 0, 0}))};
  for (int c = 1; c < 8; ++c) {
    const glm::vec3 p(geometry.toWorld({c & 1 ? last.x : 0, c & 2 ? last.y : 0, c & 4 ? last.z : 0}));
    box.min = glm::min(box.min, p);
    box.max = glm::max(box.max, p);
  }
  return box;
}

}  // namespace sonoskin
