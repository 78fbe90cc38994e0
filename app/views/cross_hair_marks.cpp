#include "app/views/cross_hair_marks.h"

#include "app/views/projection.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "core/mesh/search/ray_hit.h"

namespace sonoskin::ui {
namespace {

// A place on the surface is not behind it.
float tolerance(const Geometry& geometry) { return 2 * float(geometry.minSpacing()); }

void drawLines(const PaneInput& pane, const Workspace& workspace) {
  const Geometry& g = workspace.session.scan().volume->geometry;
  const ViewState& view = workspace.view;
  const glm::dvec3 index = g.toIndex(view.cursor);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 from = index, to = index;
    from[axis] = -0.5;
    to[axis] = g.dims[axis] - 0.5;
    const auto a = seenAt(glm::vec3(g.toWorld(from)), view.camera, pane);
    const auto b = seenAt(glm::vec3(g.toWorld(to)), view.camera, pane);
    const glm::vec3 c = planeColour(view.planes.across(axis));
    if (a && b)
      ImGui::GetWindowDrawList()->AddLine({a->x, a->y}, {b->x, b->y},
                                          ImGui::GetColorU32({c.r, c.g, c.b, 0.35f}), unit());
  }
}

}  // namespace

bool isBehindVolume(const VolumeScene& scene, const glm::vec3& eye, const glm::vec3& place) {
  const Volume<float>& volume = *scene.volume;
  const Geometry& g = volume.geometry;
  const glm::vec3 last(g.dims - 1);
  const glm::vec3 least = scene.part.cropMin * last, most = scene.part.cropMax * last;
  const glm::vec3 from(g.toIndex(glm::dvec3(eye))), to(g.toIndex(glm::dvec3(place)));
  const float length = glm::distance(eye, place), step = 0.7f * float(g.minSpacing());
  for (float at = 0; at < length - tolerance(g); at += step) {
    const glm::vec3 index = glm::mix(from, to, at / length);
    if (glm::any(glm::lessThan(index, least)) || glm::any(glm::greaterThan(index, most))) continue;
    const glm::ivec3 v(glm::round(index));
    if (volume.at(v.x, v.y, v.z) > scene.level) return true;
  }
  return false;
}

void CrossHairSight::update(const Workspace& w, bool moving) {
  const glm::vec3 nowEye = w.view.camera.eye(), nowPlace(w.view.cursor);
  if (!showsMesh(w)) {
    const VolumeScene scene = volumeScene(w);
    hidden = scene.look == VolumeLook::surface && isBehindVolume(scene, nowEye, nowPlace);
    from.see({nullptr});
    return;
  }
  if (moving) return;
  const auto& mesh = w.session.results().mesh;
  const bool another = from.see({mesh});
  if (!another && eye == nowEye && place == nowPlace) return;
  eye = nowEye;
  place = nowPlace;
  const float length = glm::distance(eye, place);
  const auto hit = firstHit(*mesh, eye, (place - eye) / length);
  hidden = hit && *hit < length - tolerance(w.session.scan().volume->geometry);
}

void drawCrossHairInSpace(const PaneInput& pane, const Workspace& workspace, bool hidden) {
  if (!hidden) drawLines(pane, workspace);
  const auto at = seenAt(glm::vec3(workspace.view.cursor), workspace.view.camera, pane);
  if (!at) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!hidden) list.AddCircle({at->x, at->y}, 4 * unit(), IM_COL32(0, 0, 0, 150), 0, 3 * unit());
  list.AddCircle({at->x, at->y}, 4 * unit(), IM_COL32(235, 240, 245, hidden ? 70 : 220), 0, 1.3f * unit());
  notePlace("space.crossHair", *at, 4 * unit());
}

}  // namespace sonoskin::ui
