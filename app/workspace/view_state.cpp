#include "app/workspace/view_state.h"

namespace sonoskin {

double levelOf(const ViewState& view, const Results& results, SliceLayer layer) {
  constexpr double kStrongClassified = 0.3, kThinned = 0.15;
  const double found = results.visibleLevel > 0 ? results.visibleLevel : 0.3;
  if (layer == SliceLayer::thinned) return kThinned;  // interpolation halves what is one voxel thin
  const bool isRaw = layer == SliceLayer::raw;
  const double standard = isRaw ? found : kStrongClassified;
  return isRaw == (view.volumeLayer == VolumeLayer::raw) ? view.volumeLevel.value_or(standard) : standard;
}

double shownLevel(const ViewState& view, const Results& results) {
  return levelOf(view, results,
                 view.volumeLayer == VolumeLayer::raw ? SliceLayer::raw : SliceLayer::classified);
}

Box surroundings(const Scan& scan, const Results& results) {
  if (results.points && results.points->size() > 0) return boundingBox(results.points->positions);
  return worldBox(scan.volume->geometry);
}

std::array<glm::vec3, 2> cropTo(const Box& box, const Geometry& geometry, float margin) {
  glm::dvec3 least(1e30), most(-1e30);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 far(corner & 1, corner & 2, corner & 4);
    const glm::dvec3 index = geometry.toIndex(glm::dvec3(glm::mix(box.min - margin, box.max + margin, far)));
    least = glm::min(least, index);
    most = glm::max(most, index);
  }
  const glm::dvec3 last = glm::max(glm::dvec3(geometry.dims - 1), glm::dvec3(1));
  return {glm::vec3(glm::clamp(least / last, 0.0, 1.0)), glm::vec3(glm::clamp(most / last, 0.0, 1.0))};
}

void resetCamera(ViewState& view, const ViewFrame& frame, const Box& box) {
  view.camera =
      lookAlong(glm::vec3(frame.turned(frame.forward)), glm::vec3(frame.turned(frame.up)), box, 1.2f);
  view.cameraMoved = false;
}

void turnCamera(Camera& camera, const ViewFrame& before, const ViewFrame& after) {
  const glm::dmat3 change = after.turn * glm::transpose(before.turn);
  const glm::mat3 world(after.directions * change * glm::transpose(after.directions));
  camera.forward = glm::normalize(world * camera.forward);
  camera.up = glm::normalize(world * camera.up);
}

void turnView(ViewState& view, const ViewFrame& frame, Plane plane) {
  ViewFrame turned = frame;
  turned.turn = view.orientation.turn = turnedInPlane(frame, plane);
  turnCamera(view.camera, frame, turned);
  view.cameraMoved = true;
}

void resetOblique(ViewState& view, const Geometry& geometry) {
  view.oblique = {directionsOf(geometry, view.planes[Plane::axial])};
}

void resetView(ViewState& view, const Scan& scan, const Beam& beam) {
  if (!scan.volume) return;
  const Geometry& g = scan.volume->geometry;
  view.cursor = g.toWorld(glm::dvec3((g.dims - 1) / 2));
  view.grey = {};
  view.slices.fill({.pan = {0, 0}, .zoom = 0.92});  // a margin for the marks
  view.linkedScale = 0;
  view.volumeLevel.reset();
  view.maximised.reset();
  view.clip = {};
  view.turntable = false;
  const ViewFrame frame = viewFrameOf(scan, beam, view.orientation);
  view.planes = planeAxes(g, frame);
  resetOblique(view, g);
  resetCamera(view, frame, worldBox(g));
}

}  // namespace sonoskin
