#include "app/views/skin_marks.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/landmarks.h"
#include "app/texts/texts.h"
#include "app/views/lamp_marks.h"
#include "app/views/projection.h"
#include "app/widgets/theme.h"
#include "core/mesh/search/ray_hit.h"
#include "core/pipeline/face_use.h"
#include "core/skin/scatter_profile.h"

namespace sonoskin::ui {
namespace {

constexpr ImU32 kShade = IM_COL32(0, 0, 0, 170);

ImVec2 at(const glm::vec2& p) { return {p.x, p.y}; }

// How far light spreads depends on few parameters: fitted again when they change.
const GaussianSum& spread(const SkinOptions& options) {
  static SkinOptions of;
  static GaussianSum sum = diffusionOf(of);
  if (!(of == options)) {
    of = options;
    sum = diffusionOf(of);
  }
  return sum;
}

// A small mark with its name for each that is set; what to do while one is being placed.
void drawLandmarks(const Workspace& workspace, const PaneInput& pane) {
  const LandmarkOptions landmarks =
      landmarksWithFace(workspace.session.parameters(), workspace.session.results().face.get());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float u = unit();
  for (const NamedLandmark& landmark : kLandmarks) {
    const std::array<double, 3>& place = landmarks.*landmark.place;
    if (!isSet(place)) continue;
    const auto seen = seenAt(glm::vec3(place[0], place[1], place[2]), workspace.view.camera, pane);
    if (!seen) continue;
    list.AddCircle(at(*seen), 4 * u, kShade, 16, 3 * u);
    list.AddCircle(at(*seen), 4 * u, ImGui::GetColorU32(kAccent), 16, 1.5f * u);
    shadedText({seen->x + 8 * u, seen->y - 7 * u}, kText, tr(landmark.name));
  }
  if (isChosen(workspace.view, Tool::landmark)) {
    const std::string text = trf("Click on: {}", tr(kLandmarks[workspace.view.landmark].name));
    shadedText({pane.corner.x + 12 * u, pane.corner.y + 32 * u}, kWarning, text);
  }
}

// Rings around the place in the middle, as far as half and nine tenths of the red and the green light go.
void drawReach(const Workspace& workspace, const PaneInput& pane) {
  const Camera& camera = workspace.view.camera;
  const glm::vec3 direction = rayThrough(0.5f * pane.size, camera, pane);
  const auto hit = firstHit(*workspace.session.results().mesh, camera.eye(), direction);
  if (!hit) return;
  const float pixels = pixelsPerTangent(camera, pane) / *hit, u = unit();
  const GaussianSum& diffusion = spread(workspace.session.parameters().skin);
  const glm::vec2 middle = pane.corner + 0.5f * pane.size;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr std::array<ImU32, 2> kColours{IM_COL32(255, 120, 110, 255), IM_COL32(130, 230, 130, 255)};
  std::array<double, 2> most{};
  for (int channel = 0; channel < 2; ++channel) {
    for (const double share : {0.5, 0.9}) {
      const double mm = radiusOfEnergy(diffusion, channel, share);
      most[std::size_t(channel)] = mm;
      const float r = float(mm) * pixels;
      list.AddCircle(at(middle), r, kShade, 64, (share < 0.6 ? 3.2f : 2.4f) * u);
      list.AddCircle(at(middle), r, kColours[std::size_t(channel)], 64, (share < 0.6 ? 1.8f : 1.f) * u);
    }
  }
  const float below = middle.y + float(std::max(most[0], most[1])) * pixels + 6 * u;
  constexpr std::array<const char*, 2> kTexts{"red: half within {:.2f} mm, nine tenths within {:.1f} mm",
                                              "green: half within {:.2f} mm, nine tenths within {:.1f} mm"};
  for (int channel = 0; channel < 2; ++channel) {
    const std::string text = trf(kTexts[std::size_t(channel)], radiusOfEnergy(diffusion, channel, 0.5),
                                 most[std::size_t(channel)]);
    const float width = smallFont()->CalcTextSizeA(smallFont()->FontSize, FLT_MAX, 0, text.c_str()).x;
    shadedText({middle.x - 0.5f * width, below + float(channel) * 1.15f * smallFont()->FontSize}, kText,
               text);
  }
}

}  // namespace

void drawSkinMarks(const ToolState& state, const Workspace& workspace, const PaneInput& pane) {
  const SkinShow& show = workspace.view.skin;
  const bool held = state.held == Tool::lamp;
  const bool dividerHeld = held && state.lamp.divider, lampHeld = held && !state.lamp.divider;
  const bool onLamp = isOnLamp(workspace, pane), onDivider = isOnDivider(workspace, pane);
  if (show.compare != SkinCompare::off) drawDivider(workspace, pane, dividerHeld || onDivider);
  if (show.reach) drawReach(workspace, pane);
  if (show.places || isChosen(workspace.view, Tool::landmark)) drawLandmarks(workspace, pane);
  if (show.lamp) drawLamp(workspace, pane, lampHeld || onLamp);
  if (dividerHeld || (!lampHeld && onDivider)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (lampHeld || onLamp) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace sonoskin::ui
