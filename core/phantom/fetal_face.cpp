#include "core/phantom/fetal_face.h"

#include <cmath>

#include "core/phantom/fetal_body.h"
#include "core/phantom/fetal_head.h"
#include "core/phantom/sdf.h"

namespace sonoskin {
namespace {

using namespace sdf;

// The head's frame in the world: turned a little to its right, bowed a little, and tilted, as babies lie.
struct Pose {
  vec3 centre{57, 71, 56};
  glm::mat3 worldToHead;

  Pose() {
    constexpr double yaw = 0.17, pitch = 0.05, roll = -0.06;
    const glm::dmat3 axes{
        {0, -1, 0}, {0, 0, -1}, {1, 0, 0}};  // columns: where world x, y, z point in the head
    const glm::dmat3 turn{{std::cos(yaw), 0, -std::sin(yaw)}, {0, 1, 0}, {std::sin(yaw), 0, std::cos(yaw)}};
    const glm::dmat3 bow{
        {1, 0, 0}, {0, std::cos(pitch), std::sin(pitch)}, {0, -std::sin(pitch), std::cos(pitch)}};
    const glm::dmat3 tilt{
        {std::cos(roll), std::sin(roll), 0}, {-std::sin(roll), std::cos(roll), 0}, {0, 0, 1}};
    worldToHead = glm::mat3(bow * turn * tilt * axes);
  }
  vec3 toHead(const glm::dvec3& world) const { return worldToHead * (vec3(world) - centre); }
  glm::dvec3 toWorld(const vec3& head) const {
    return glm::dvec3(glm::transpose(worldToHead) * head + centre);
  }
};

const Pose& pose() {
  static const Pose kPose;
  return kPose;
}

// The skin of the face at x to the baby's left and y upward, seen from before it.
glm::dvec3 onFace(float x, float y) {
  constexpr float kBefore = 60, kCloseEnough = 1e-3f;
  vec3 p{x, y, kBefore};
  for (float d = headSkin(p); d > kCloseEnough && p.z > 0; d = headSkin(p)) p.z -= 0.7f * d;
  return pose().toWorld(p);
}

}  // namespace

double skinDistance(const glm::dvec3& world) {
  const vec3 p = pose().toHead(world);
  const float trunk = smoothMin(headSkin(p), bodySkin(p), 5);
  return double(smoothMin(trunk, armSkin(p), 1.2f));
}

FacePlaces facePlaces() {
  return {onFace(-14.4f, -1.4f), onFace(14.4f, -1.4f), onFace(0, -12.6f), onFace(-11, -26.4f),
          onFace(11, -26.4f)};
}

double boneDistance(const glm::dvec3& world) {
  const vec3 p = pose().toHead(world);
  return double(std::min({headBone(p), bodyBone(p), armBone(p)}));
}

double wallDistance(const glm::dvec3& world) {
  const vec3 p(world);
  const float folds =
      1.6f * std::sin(p.x / 17) + 1.3f * std::cos(p.z / 12) + 0.6f * std::sin((p.x + p.z) / 6);
  float d = (p.y - 8.5f - folds) * 0.96f;
  const float lobes = 0.6f * std::sin(p.x / 4.5f) * std::sin(p.z / 5);
  d = smoothMin(d, ellipsoid(p, {14, 4, 100}, {40, 16, 34}) + lobes, 4);  // placenta
  return double(smoothMin(d, -ellipsoid(p, {72, 66, 56}, {94, 72, 74}), 6));
}

}  // namespace sonoskin
