#include "app/views/cast_window.h"

#include <fmt/format.h>

#include "app/texts/texts.h"
#include "app/views/box_lines.h"
#include "app/views/cross_hair_marks.h"
#include "app/views/space_picture.h"
#include "app/views/steering.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

// What of the 3D view's marks helps to compare: the tools are that view's own.
void drawMarks(const PaneInput& pane, const Workspace& w, const VolumeScene& scene, SliceLayer layer) {
  const ViewState& view = w.view;
  const bool there = scene.volume || scene.bytes;
  if (there && view.cropBox) drawBoxLines(pane, w);
  if (there && view.crossHairInSpace) {
    const bool hides = scene.look == VolumeLook::surface && scene.volume;
    drawCrossHairInSpace(pane, w, hides && isBehindVolume(scene, view.camera.eye(), glm::vec3(view.cursor)));
  }
  const bool coarse = layer == SliceLayer::classified && w.session.classifiedIsCoarse();
  const bool levelled = scene.look != VolumeLook::maximum;
  paneTitle(pane, tr(layerName(layer)), kSurface,
            fmt::format("{}{}{}", levelled ? fmt::format("{} {:.2f}", tr("level"), scene.level) : "",
                        levelled && coarse ? ", " : "", coarse ? tr("coarse") : ""));
  scaleBar(pane, 1 / double(view.camera.millimetresPerPixel(static_cast<int>(pane.size.y))));
}

}  // namespace

double drawCast(SpaceWindow& window, GpuScans& scans, Workspace& w, const PaneInput& pane) {
  if (!w.session.hasScan()) {
    paneTitle(pane, tr(layerName(*window.compared)), kSurface, "");
    return -1;
  }
  const double now = ImGui::GetTime();
  if (steer(w.view.camera, pane)) w.view.cameraMoved = true;
  if (pane.wheel != 0) window.restsAt = now + kWheelRests;
  window.steered = pane.button >= 0 || now < window.restsAt;
  window.state.moving = window.steered || window.share.moves;
  const VolumeScene scene = comparedScene(w, *window.compared);
  if (scene.volume || scene.bytes) {
    advancePicture(window, scans, w, glm::max(glm::ivec2(pane.size), glm::ivec2(1)));
    showTexture(pane, window.picture);
  } else {
    window.state.unfinished = false;
    window.picture = {};
  }
  if (!window.picture) paneText(pane, tr("Not made yet"));
  drawMarks(pane, w, scene, *window.compared);
  if (window.picture && window.state.unfinished) return 0;
  return now < window.restsAt ? window.restsAt - now : -1;
}

}  // namespace sonoskin::ui
