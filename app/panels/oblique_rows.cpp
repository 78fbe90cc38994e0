// How the oblique slice is turned against the axial one, in numbers.
#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/panels/view_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

// Number: one of the angles.
struct Number {
  const char *id, *format, *help;
  double ObliqueAngles::*angle;
  float most;  // degrees to either side
};

constexpr std::array<Number, 3> kNumbers{{
    {"oblique.tilt", "Tilt %.0f°",
     "About the line to the right in the axial picture. Drag, or double click to type.", &ObliqueAngles::tilt,
     180},
    {"oblique.turn", "Turn %.0f°",
     "About the line downward in the axial picture. Drag, or double click to type.", &ObliqueAngles::turn,
     90},
    {"oblique.roll", "Roll %.0f°", "In the picture itself. Drag, or double click to type.",
     &ObliqueAngles::roll, 180},
}};

float widthOf(const Number& number) {
  char text[64];
  std::snprintf(text, sizeof text, tr(number.format), -double(number.most));
  return ImGui::CalcTextSize(text).x + 10 * unit();
}

const char* resetTitle() { return tr("Reset"); }

float resetWidth() { return ImGui::CalcTextSize(resetTitle()).x + 12 * unit(); }

float gap() { return 3 * unit(); }

}  // namespace

void drawObliqueNumbers(Workspace& workspace) {
  PlaneDirections& plane = workspace.view.oblique.directions;
  const PlaneDirections base =
      directionsOf(workspace.session.scan().volume->geometry, workspace.view.planes[Plane::axial]);
  ObliqueAngles angles = anglesOf(plane, base);
  // They stand in a bar among buttons.
  ImGui::PushStyleColor(ImGuiCol_FrameBg, ImGui::GetStyleColorVec4(ImGuiCol_Button));
  ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, ImGui::GetStyleColorVec4(ImGuiCol_ButtonHovered));
  ImGui::PushStyleColor(ImGuiCol_FrameBgActive, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  for (const Number& number : kNumbers) {
    float shown = std::round(float(angles.*number.angle)) + 0.0f;  // 0, not -0
    ImGui::SetNextItemWidth(widthOf(number));
    const std::string id = std::string("##") + number.id;
    if (ImGui::DragFloat(id.c_str(), &shown, 0.5f, -number.most, number.most, tr(number.format),
                         ImGuiSliderFlags_AlwaysClamp)) {
      angles.*number.angle = double(shown);
      plane = directionsAt(angles, base);
    }
    noteWidget(number.id);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) ImGui::SetTooltip("%s", tr(number.help));
    ImGui::SameLine(0, gap());
  }
  ImGui::PopStyleColor(3);
  const Command& reset = command("oblique.reset");
  if (ImGui::Button(resetTitle(), {resetWidth(), 0})) reset.run(workspace);
  noteWidget(reset.id);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr("As the axial plane"));
}

float obliqueNumbersWidth() {
  float width = resetWidth();
  for (const Number& number : kNumbers) width += widthOf(number) + gap();
  return width;
}

}  // namespace sonoskin::ui
