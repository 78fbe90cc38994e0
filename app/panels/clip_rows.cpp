// The plane that cuts what the 3D view shows.
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/panels/view_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/clip_edits.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

void drawDepth(Workspace& workspace) {
  beginRow(tr("Position"));
  const auto [least, most] = clipRange(workspace);
  float at = std::round(10 * clipDepth(workspace)) / 10 + 0.0f;  // 0, not -0
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("##clip", &at, least, most, "%.1f mm", ImGuiSliderFlags_AlwaysClamp))
    moveClip(workspace, at);
  noteWidget("clip.place");
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    ImGui::SetTooltip(
        "%s", tr("Along the plane's normal, from the middle of what is shown. The arrow in the view can be "
                 "dragged as well."));
}

void drawNormals(Workspace& workspace) {
  struct Choice {
    const char *title, *id;
  };
  const ViewFrame frame = workspace.viewFrame();
  const std::array choices{
      Choice{tr("View"), "clip.view"}, Choice{tr(planeName(frame, Plane::axial)), "clip.axial"},
      Choice{tr(planeName(frame, Plane::sagittal)), "clip.sagittal"},
      Choice{tr(planeName(frame, Plane::coronal)), "clip.coronal"}, Choice{tr("Flip"), "clip.flip"}};
  beginRow(tr("Facing"));
  const float gap = 2 * unit();
  for (const Choice& choice : choices) {
    const float width = ImGui::CalcTextSize(choice.title).x + 10 * unit();
    if (&choice != choices.data()) ImGui::SameLine(0, gap);
    if (ImGui::Button(choice.title, {width, 0})) command(choice.id).run(workspace);
    noteWidget(choice.id);
  }
}

}  // namespace

void drawClipRows(Workspace& workspace) {
  bool on = workspace.view.clip.on;
  if (ImGui::Checkbox(tr("Clip plane"), &on)) command("clip.on").run(workspace);
  noteWidget("clip.on");
  if (!workspace.view.clip.on || !beginFields("clip rows")) return;
  drawDepth(workspace);
  drawNormals(workspace);
  endFields();
}

}  // namespace sonoskin::ui
