#include <cmath>

#include "app/document/landmarks.h"
#include "app/texts/texts.h"
#include "app/views/projection.h"
#include "app/views/tools.h"
#include "core/mesh/search/ray_hit.h"

namespace sonoskin::ui {
namespace {

double tenths(float value) { return std::round(10 * double(value)) / 10; }

// The surface below the mouse gets the landmark.
void place(Workspace& w, const PaneInput& input) {
  const Camera& camera = w.view.camera;
  const glm::vec3 direction = rayThrough(input.mouse, camera, input);
  const auto hit = firstHit(*w.session.results().mesh, camera.eye(), direction);
  if (!hit) {
    w.toasts.add(tr("There is no surface there: click on the face."), false);
    return;
  }
  const glm::vec3 at = camera.eye() + *hit * direction;
  Parameters p = w.session.parameters();
  p.landmarks.*kLandmarks[w.view.landmark].place = {tenths(at.x), tenths(at.y), tenths(at.z)};
  w.session.edit(p);
  w.session.commitEdit();
  putAway(w.view, Tool::landmark);
}

}  // namespace

PaneInput useLandmarkTool(ToolState&, Workspace& w, const ToolPane& pane) {
  if (!holdsLeft(pane.input) || pane.input.shift) return pane.input;
  if (pane.input.pressed) place(w, pane.input);
  return withoutButton(pane.input);
}

}  // namespace sonoskin::ui
