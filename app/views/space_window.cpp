#include "app/views/space_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/texts/texts.h"
#include "app/views/box_lines.h"
#include "app/views/cross_hair_marks.h"
#include "app/views/measure_marks.h"
#include "app/views/oblique_marks.h"
#include "app/views/skin_marks.h"
#include "app/views/space_handles.h"
#include "app/views/space_picture.h"
#include "app/views/use_tool.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr double kPreparingSeconds = 0.06;  // between looks at how far the skin is prepared

std::string meshCaption(const SpaceWindow& window, const Workspace& w) {
  std::string text = trf("{} triangles", grouped(w.session.results().mesh->triangles.size()));
  if (!w.session.meshIsCurrent()) {
    text += std::string(", ") + tr("stale");
  } else if (!w.session.meshIsFinal()) {
    text += fmt::format(" ({})", tr("live"));
  }
  const std::string preparing = wantsSkin(w) ? window.skin.caption() : "";
  return preparing.empty() ? text : preparing;
}

std::string caption(const SpaceWindow& window, const Workspace& w) {
  const ViewState& v = w.view;
  if (showsParts(w)) return partCaption(w);
  if (showsMesh(w)) return meshCaption(window, w);
  const bool raw = v.volumeLayer == VolumeLayer::raw;
  const char* layer = tr(raw ? "raw" : w.session.classifiedIsCoarse() ? "coarse" : "classified");
  return trf("{}, level {:.2f}", layer, shownLevel(v, w.session.results()));
}

// The turntable, while nothing else has the mouse; whether it has turned.
bool turnOn(Workspace& w, const PaneInput& pane) {
  constexpr double kTurnSeconds = 9, kLongestStep = 0.2;  // after a stall it goes on where it was
  if (!w.view.turntable || pane.button >= 0 || w.view.toolHeld || w.view.catchingUp) return false;
  w.view.camera =
      w.view.camera.aroundBy(std::min(double(ImGui::GetIO().DeltaTime), kLongestStep) / kTurnSeconds);
  w.view.cameraMoved = true;
  return true;
}

}  // namespace

double drawSpaceWindow(SpaceWindow& window, GpuScans& scans, Workspace& workspace, const PaneInput& pane) {
  const double now = ImGui::GetTime();
  if (!workspace.session.hasScan()) {
    const Activity activity = workspace.session.activity();
    if (activity.busy)
      paneText(pane, fmt::format("{}  {:.0f} %", trSentence(activity.what), 100 * activity.fraction));
    paneTitle(pane, "3D", kSurface, "");
    return -1;
  }
  const bool skin = wantsSkin(workspace);
  if (skin) {
    for (const std::string& failure : window.skin.update(workspace)) workspace.toasts.add(failure, true);
  }
  const ViewFrame frame = workspace.viewFrame();
  ViewState& view = workspace.view;
  useTool(window.tools, workspace, {useCube(window.cube, frame, pane, view.camera, view.cameraMoved)});
  if (pane.wheel != 0) window.restsAt = now + kWheelRests;
  const bool turns = turnOn(workspace, pane);
  window.steered = turns || pane.button >= 0 || view.toolHeld || now < window.restsAt;
  window.state.moving = window.steered || window.share.moves;
  advancePicture(window, scans, workspace, glm::ivec2(pane.size));
  showTexture(pane, window.picture);
  if (showsBoxInSpace(workspace)) {
    drawBoxLines(pane, workspace);
    drawCropHandles(window.tools, workspace, pane);
  }
  drawObliqueInSpace(pane, workspace);
  if (workspace.view.clip.on) drawClipHandle(window.tools, workspace, pane);
  if (skin) drawSkinMarks(window.tools, workspace, pane);
  if (view.crossHairInSpace) {
    window.sight.update(workspace, window.state.moving);
    drawCrossHairInSpace(pane, workspace, window.sight.hidden);
  }
  drawMeasuresInSpace(pane, workspace);
  drawTool(window.tools, workspace, {pane});
  if (showsParts(workspace)) drawPartHints(pane);
  paneTitle(pane, "3D", kSurface, caption(window, workspace));
  drawCube(window.cube, frame, pane, view.camera);
  scaleBar(pane, 1 / double(workspace.view.camera.millimetresPerPixel(static_cast<int>(pane.size.y))));
  if (turns || (window.picture && window.state.unfinished)) return 0;
  if (skin && (window.skin.preparing() || window.skin.refining())) return kPreparingSeconds;
  return now < window.restsAt ? window.restsAt - now : -1;
}

}  // namespace sonoskin::ui
