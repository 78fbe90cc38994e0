#include "app/panels/state_mark.h"

#include <cmath>

#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

// A ring of which a part goes around.
void drawWorking(ImDrawList& list, ImVec2 c, ImU32 colour) {
  const float from = float(std::fmod(4 * ImGui::GetTime(), 6.2832));
  list.PathArcTo(c, 5 * unit(), from, from + 4.2f, 16);
  list.PathStroke(colour, 0, 2 * unit());
}

void drawTick(ImDrawList& list, ImVec2 c, ImU32 colour) {
  const float u = unit();
  const ImVec2 points[] = {{c.x - 5 * u, c.y}, {c.x - 1.5f * u, c.y + 3.5f * u}, {c.x + 5 * u, c.y - 4 * u}};
  list.AddPolyline(points, 3, colour, 0, 2 * u);
}

void drawCross(ImDrawList& list, ImVec2 c, ImU32 colour) {
  const float r = 4 * unit();
  list.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, 2 * unit());
  list.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, colour, 2 * unit());
}

}  // namespace

ImVec4 colourOf(StageState state) {
  switch (state) {
    case StageState::nothing:
      return colours().faintText;
    case StageState::working:
    case StageState::live:
      return colours().accent;
    case StageState::ready:
      return colours().good;
    case StageState::stale:
    case StageState::stopped:
      return colours().warning;
    case StageState::failed:
      return colours().failure;
  }
  return colours().text;
}

void drawStateMark(StageState state, ImVec2 c) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(colourOf(state));
  const float u = unit();
  switch (state) {
    case StageState::nothing:
      return list.AddCircle(c, 4.5f * u, colour, 16, 1.2f * u);
    case StageState::working:
      return drawWorking(list, c, colour);
    case StageState::ready:
      return drawTick(list, c, colour);
    case StageState::live:
      list.AddCircle(c, 4.5f * u, colour, 16, 1.5f * u);
      return list.AddCircleFilled(c, 2 * u, colour);
    case StageState::stale:
      return list.AddTriangle({c.x - 5 * u, c.y + 4 * u}, {c.x + 5 * u, c.y + 4 * u}, {c.x, c.y - 5 * u},
                              colour, 1.6f * u);
    case StageState::stopped:
      return list.AddRectFilled({c.x - 4 * u, c.y - 4 * u}, {c.x + 4 * u, c.y + 4 * u}, colour);
    case StageState::failed:
      return drawCross(list, c, colour);
  }
}

}  // namespace sonoskin::ui
