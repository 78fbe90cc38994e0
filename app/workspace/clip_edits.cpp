#include "app/workspace/clip_edits.h"

#include <algorithm>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

Box shownBox(const Workspace& w) {
  const Results& results = w.session.results();
  if (w.view.content == SpaceContent::mesh && results.mesh) return boundingBox(results.mesh->positions);
  if (w.view.crop) return surroundings(w.session.scan(), results);
  return worldBox(w.session.scan().volume->geometry);
}

void put(Workspace& w, const glm::vec3& place, const glm::vec3& normal) {
  w.view.clip = {true, clipPlaneThrough(place, normal)};
}

}  // namespace

void switchClip(Workspace& w) {
  if (w.view.clip.plane.normal == glm::vec3(0)) return clipFromView(w);
  w.view.clip.on = !w.view.clip.on;
}

void clipFromView(Workspace& w) { put(w, shownBox(w).centre(), w.view.camera.forward); }

void clipFromPlane(Workspace& w, Plane plane) {
  glm::vec3 normal(w.session.scan().volume->geometry.direction[w.view.planes[plane].across]);
  if (glm::dot(normal, w.view.camera.forward) < 0) normal = -normal;
  put(w, glm::vec3(w.view.cursor), normal);
}

void flipClip(Workspace& w) {
  ClipPlane& plane = w.view.clip.plane;
  plane = {-plane.normal, -plane.offset};
}

float clipDepth(const Workspace& w) {
  const ClipPlane& plane = w.view.clip.plane;
  return -(glm::dot(plane.normal, shownBox(w).centre()) + plane.offset);
}

std::array<float, 2> clipRange(const Workspace& w) {
  const Box box = shownBox(w);
  const float half = 0.5f * glm::dot(glm::abs(w.view.clip.plane.normal), box.max - box.min);
  return {-half, half};
}

void moveClip(Workspace& w, float depth) {
  const auto [least, most] = clipRange(w);
  const glm::vec3 normal = w.view.clip.plane.normal;
  put(w, shownBox(w).centre() + std::clamp(depth, least, most) * normal, normal);
}

glm::vec3 clipMiddle(const Workspace& w) {
  return shownBox(w).centre() + clipDepth(w) * w.view.clip.plane.normal;
}

}  // namespace sonoskin
