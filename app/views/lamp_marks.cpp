#include "app/views/lamp_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/texts/texts.h"
#include "app/views/skin_scene.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/lamp_dial.h"

namespace sonoskin::ui {
namespace {

constexpr float kReach = 14, kDividerReach = 6;  // of the mouse, at content scale 1
constexpr float kDialShare = 0.36f;              // of the pane's shorter side
constexpr ImU32 kShade = IM_COL32(0, 0, 0, 170);

ImVec2 at(const glm::vec2& p) { return {p.x, p.y}; }

// Roughly the light's own tone.
ImVec4 toneOf(const LightOptions& light) {
  const float cold = static_cast<float>(std::clamp((light.warmth - 2500) / 5000, 0.0, 1.0));
  return {1, 0.72f + 0.22f * cold, 0.36f + 0.62f * cold, 1};
}

void drawRays(ImDrawList& list, const glm::vec2& middle, float from, float to, ImU32 colour) {
  for (int n = 0; n < 8; ++n) {
    const float angle = float(n) * std::numbers::pi_v<float> / 4;
    const glm::vec2 along(std::cos(angle), std::sin(angle));
    list.AddLine(at(middle + from * along), at(middle + to * along), colour, 1.6f * unit());
  }
}

std::string lampText(const LightOptions& light) {
  const std::string angles = fmt::format("{:.0f}°, {:.0f}°", light.azimuth, light.elevation);
  if (light.kind == LightKind::far) return angles;
  return trf("{}, distance {:.0f}", angles, light.distance);
}

}  // namespace

float dialRadius(const PaneInput& pane) { return kDialShare * std::min(pane.size.x, pane.size.y); }

glm::vec2 lampPlace(const Workspace& workspace, const PaneInput& pane) {
  const glm::vec3 toward = lightPlace(workspace.session.parameters().light, homeOf(workspace));
  const glm::vec2 on = dialPlace(toward, workspace.view.camera);
  return 0.5f * pane.size + dialRadius(pane) * glm::vec2(on.x, -on.y);
}

bool isOnLamp(const Workspace& w, const PaneInput& pane) {
  return w.view.skin.lamp && pane.hovered && glm::distance(pane.mouse, lampPlace(w, pane)) < kReach * unit();
}

bool isOnDivider(const Workspace& w, const PaneInput& pane) {
  return w.view.skin.compare != SkinCompare::off && pane.hovered &&
         std::abs(pane.mouse.x - w.view.skin.divider * pane.size.x) < kDividerReach * unit();
}

void drawLamp(const Workspace& workspace, const PaneInput& pane, bool near) {
  const LightOptions& light = workspace.session.parameters().light;
  const glm::vec3 toward = lightPlace(light, homeOf(workspace));
  const bool behind = glm::dot(toward, workspace.view.camera.forward) > 0;
  const glm::vec2 middle = pane.corner + lampPlace(workspace, pane);
  const float u = unit(), r = (near ? 7 : 6) * u;
  const ImU32 colour = ImGui::GetColorU32(toneOf(light));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (near) {
    list.AddCircle(at(pane.corner + 0.5f * pane.size), dialRadius(pane), IM_COL32(255, 255, 255, 70), 96, u);
    const float width =
        smallFont()->CalcTextSizeA(smallFont()->FontSize, FLT_MAX, 0, lampText(light).c_str()).x;
    const bool left = middle.x - pane.corner.x > 0.7f * pane.size.x;
    shadedText({middle.x + (left ? -20 * u - width : 20 * u), middle.y - 7 * u}, kText, lampText(light));
  }
  notePlace("lamp", middle, r);
  list.AddCircleFilled(at(middle), r + 1.5f * u, kShade, 24);
  if (behind) {
    list.AddCircle(at(middle), r, colour, 24, 1.8f * u);
  } else {
    list.AddCircleFilled(at(middle), r, colour, 24);
  }
  if (light.kind == LightKind::far) drawRays(list, middle, r + 3 * u, r + 7 * u, colour);
  if (light.kind == LightKind::inside) list.AddCircle(at(middle), r + 4 * u, colour, 24, 1.2f * u);
  if (light.kind == LightKind::near)
    list.AddLine(at(middle + glm::vec2(-4, 10) * u), at(middle + glm::vec2(4, 10) * u), colour, 2 * u);
}

void drawDivider(const Workspace& workspace, const PaneInput& pane, bool near) {
  const SkinShow& show = workspace.view.skin;
  const float u = unit(), x = pane.corner.x + show.divider * pane.size.x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = near ? ImGui::GetColorU32(kAccent) : IM_COL32(235, 235, 235, 190);
  list.AddLine({x, pane.corner.y}, {x, pane.corner.y + pane.size.y}, colour, (near ? 2.f : 1.f) * u);
  const bool scatter = show.compare == SkinCompare::scatter;
  const std::string left = tr(scatter ? "light stays above" : "A, kept"),
                    right = tr(scatter ? "light goes in" : "B, now");
  const float width = smallFont()->CalcTextSizeA(smallFont()->FontSize, FLT_MAX, 0, left.c_str()).x;
  const float y = pane.corner.y + 32 * u;
  shadedText({x - width - 8 * u, y}, kText, left);
  shadedText({x + 8 * u, y}, kText, right);
}

}  // namespace sonoskin::ui
