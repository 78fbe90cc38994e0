#include "app/view_state.h"

namespace sonoskin {

double shownLevel(const ViewState& view, const Results& results) {
  constexpr double kStrongClassified = 0.3;
  const double found = results.isoValue > 0 ? results.isoValue : 0.3;
  return view.volumeLevel.value_or(view.volumeLayer == VolumeLayer::raw ? found : kStrongClassified);
}

void resetCamera(ViewState& view, const Scan& scan, const Beam& beam) {
  if (!scan.volume) return;
  view.camera = lookAlong(glm::vec3(beam.axis), glm::vec3(beam.up), worldBox(scan.volume->geometry), 1.2f);
}

void resetView(ViewState& view, const Scan& scan, const Beam& beam) {
  if (!scan.volume) return;
  const Geometry& g = scan.volume->geometry;
  view.cursor = g.toWorld(glm::dvec3((g.dims - 1) / 2));
  view.grey = {};
  view.slices = {};
  view.volumeLevel.reset();
  view.maximised.reset();
  resetCamera(view, scan, beam);
}

}  // namespace sonoskin
