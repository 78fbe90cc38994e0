#include "app/views/skin_tools.h"

#include <algorithm>
#include <cmath>

#include "app/document/landmarks.h"
#include "app/views/projection.h"
#include "app/views/skin_marks.h"
#include "app/views/skin_scene.h"
#include "app/widgets/theme.h"
#include "app/workspace/lamp_dial.h"
#include "core/mesh/search/ray_hit.h"

namespace sonoskin::ui {
namespace {

constexpr float kReach = 14, kDividerReach = 6;  // of the mouse, at content scale 1
constexpr double kLeastDistance = 1, kMostDistance = 1000;

double tenths(double value) { return std::round(10 * value) / 10; }

bool isOnLamp(const Workspace& w, const PaneInput& pane) {
  return w.view.skin.lamp && pane.hovered && glm::distance(pane.mouse, lampPlace(w, pane)) < kReach * unit();
}

bool isOnDivider(const Workspace& w, const PaneInput& pane) {
  return w.view.skin.compare != SkinCompare::off && pane.hovered &&
         std::abs(pane.mouse.x - w.view.skin.divider * pane.size.x) < kDividerReach * unit();
}

// The surface below the mouse gets the landmark.
void place(Workspace& w, const PaneInput& pane) {
  const Camera& camera = w.view.camera;
  const glm::vec3 direction = rayThrough(pane.mouse, camera, pane);
  const auto hit = firstHit(*w.session.results().mesh, camera.eye(), direction);
  if (!hit) {
    w.toasts.add("There is no surface there: click on the face.", false);
    return;
  }
  const glm::vec3 at = camera.eye() + *hit * direction;
  Parameters p = w.session.parameters();
  p.landmarks.*kLandmarks[*w.view.skin.placing].place = {tenths(double(at.x)), tenths(double(at.y)),
                                                         tenths(double(at.z))};
  w.session.edit(p);
  w.session.commitEdit();
  w.view.skin.placing.reset();
}

void moveLamp(const SkinTools& tools, Workspace& w, const PaneInput& pane) {
  const glm::vec2 at = (pane.mouse + tools.grip - 0.5f * pane.size) / dialRadius(pane);
  const glm::vec2 angles = lightAngles(dialDirection({at.x, -at.y}, w.view.camera), homeOf(w));
  Parameters p = w.session.parameters();
  p.light.azimuth = tenths(double(angles.x));
  p.light.elevation = tenths(double(angles.y));
  w.session.edit(p);
}

// The step for undo is made when the mouse moves on.
void turnWheel(SkinTools& tools, Workspace& w, float notches) {
  Parameters p = w.session.parameters();
  const double factor = std::pow(1.1, -double(notches));
  p.light.distance = std::clamp(tenths(factor * p.light.distance), kLeastDistance, kMostDistance);
  w.session.edit(p);
  tools.turning = true;
}

void take(SkinTools& tools, const Workspace& w, const PaneInput& pane) {
  if (isOnLamp(w, pane)) {
    tools.held = SkinTools::Held::lamp;
    tools.grip = lampPlace(w, pane) - pane.mouse;
  } else if (isOnDivider(w, pane)) {
    tools.held = SkinTools::Held::divider;
  }
}

void letGo(SkinTools& tools, Workspace& w) {
  if (tools.held == SkinTools::Held::lamp) w.session.commitEdit();
  if (tools.held != SkinTools::Held::nothing) w.view.toolHeld = false;
  tools.held = SkinTools::Held::nothing;
}

PaneInput without(PaneInput pane, bool wheelToo) {
  pane.button = -1;
  pane.pressed = pane.doubleClicked = false;
  if (wheelToo) pane.wheel = 0;
  return pane;
}

}  // namespace

PaneInput useSkinTools(SkinTools& tools, Workspace& workspace, const PaneInput& pane) {
  SkinShow& show = workspace.view.skin;
  const bool left = pane.button == ImGuiMouseButton_Left && !pane.shift;
  if (show.placing) {
    if (pane.pressed && left) place(workspace, pane);
    return left ? without(pane, false) : pane;
  }
  if (!left) letGo(tools, workspace);
  if (pane.pressed && left) take(tools, workspace, pane);
  const bool onLamp = isOnLamp(workspace, pane);
  if (tools.turning && (!onLamp || pane.pressed)) {
    workspace.session.commitEdit();
    tools.turning = false;
  }
  if (onLamp && pane.wheel != 0 && workspace.session.parameters().light.kind != LightKind::far) {
    turnWheel(tools, workspace, pane.wheel);
    return without(pane, true);
  }
  if (tools.held == SkinTools::Held::nothing) return pane;
  workspace.view.toolHeld = true;
  if (pane.moved != glm::vec2(0)) {
    if (tools.held == SkinTools::Held::lamp) moveLamp(tools, workspace, pane);
    if (tools.held == SkinTools::Held::divider)
      show.divider = std::clamp(pane.mouse.x / pane.size.x, 0.02f, 0.98f);
  }
  return without(pane, false);
}

void drawSkinMarks(const SkinTools& tools, const Workspace& workspace, const PaneInput& pane) {
  const SkinShow& show = workspace.view.skin;
  const bool dividerHeld = tools.held == SkinTools::Held::divider;
  if (show.compare != SkinCompare::off)
    drawDivider(workspace, pane, dividerHeld || isOnDivider(workspace, pane));
  if (show.reach) drawReach(workspace, pane);
  if (show.places || show.placing) drawLandmarks(workspace, pane);
  const bool lampHeld = tools.held == SkinTools::Held::lamp;
  if (show.lamp) drawLamp(workspace, pane, lampHeld || isOnLamp(workspace, pane));
  if (dividerHeld || (!lampHeld && isOnDivider(workspace, pane)))
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (lampHeld || isOnLamp(workspace, pane)) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace sonoskin::ui
