#include <fmt/format.h>
#include <imgui.h>

#include "app/document/crop_box.h"
#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

// A button of a command, over `width`; in the accent's colour while the command is on.
void commandButton(const char* id, const char* title, float width, Workspace& workspace) {
  const Command& c = command(id);
  const bool on = c.checked && c.checked(workspace);
  const DisabledIf disabled(!isEnabled(c, workspace));
  if (switchButton(title, on, width)) c.run(workspace);
  noteWidget(id);
  if (ImGui::IsItemHovered()) {
    const std::string key = shortcutText(c.shortcut);
    ImGui::SetTooltip("%s%s", c.title, key.empty() ? "" : fmt::format("   {}", key).c_str());
  }
}

float halfWidth() { return 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x); }

// One side of the crop box: where it lies along its axis, as the slices' titles count.
FieldsEdit editSide(const Side& side, float width, RegionOptions& options, const Geometry& g) {
  const std::string name = fmt::format("region.{}.{}", "ijk"[side.axis], side.high ? "high" : "low");
  const double standing = sideAt(side, options, g);
  const double least = 0, most = sideAt({side.axis, true}, {}, g);
  double mm = standing;
  ImGui::SetNextItemWidth(width);
  FieldsEdit edit;
  if (ImGui::SliderScalar(("##" + name).c_str(), ImGuiDataType_Double, &mm, &least, &most, "%.1f mm",
                          ImGuiSliderFlags_AlwaysClamp) &&
      mm != standing) {
    moveSide(side, mm, options, g);
    edit.changed = true;
  }
  edit.finished = ImGui::IsItemDeactivatedAfterEdit();
  noteWidget(name);
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    moveSide(side, side.high ? most : 0, options, g);
    edit = {true, true};
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    ImGui::SetTooltip(
        "Nothing %s this is surface. Drag the box's sides in the slices as well.\nRight click: the whole "
        "volume",
        side.high ? "beyond" : "before");
  return edit;
}

void drawSides(Workspace& workspace) {
  const Geometry& g = workspace.session.scan().volume->geometry;
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  if (beginFields("box")) {
    for (int axis = 0; axis < 3; ++axis) {
      beginRow(fmt::format("Along {}, from and to", "ijk"[axis]));
      const float width = halfWidth();
      edit |= editSide({axis, false}, width, parameters.region, g);
      ImGui::SameLine();
      edit |= editSide({axis, true}, width, parameters.region, g);
    }
    endFields();
  }
  if (edit.changed) workspace.session.edit(parameters);
  if (edit.finished) workspace.session.commitEdit();
}

void drawBox(Workspace& workspace) {
  heading(tr("Crop box"));
  sentenceText(tr("Only what lies in the box becomes surface."));
  drawSides(workspace);
  const float width = halfWidth();
  commandButton("region.box", tr("Show in the views"), width, workspace);
  ImGui::SameLine();
  commandButton("region.resetBox", tr("Whole volume"), width, workspace);
}

void drawRadius(Workspace& workspace) {
  const DisabledIf away(!isChosen(workspace.view, Tool::eraser));
  if (!beginFields("eraser")) return;
  beginRow("Radius");
  const double least = kLeastBrush, most = kMostBrush;
  ImGui::SliderScalar("##radius", ImGuiDataType_Double, &workspace.view.brushRadius, &least, &most, "%.1f mm",
                      ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  noteWidget("region.radius");
  endFields();
}

void drawEraser(Workspace& workspace) {
  heading(tr("Eraser"));
  sentenceText(tr("Drag in a slice; with Ctrl it brings back. Keys [ and ] change its size."));
  const float width = halfWidth();
  commandButton("region.erase", tr("Erase"), width, workspace);
  ImGui::SameLine();
  commandButton("region.clear", tr("Bring everything back"), width, workspace);
  drawRadius(workspace);
  const glm::dvec3& spacing = workspace.session.scan().volume->geometry.spacing;
  const double voxels = double(workspace.session.erased().voxels());
  fact(tr("Erased"), fmt::format("{:.2f} cm³", voxels * spacing.x * spacing.y * spacing.z / 1000));
}

}  // namespace

void drawRegionPanel(Workspace& workspace) {
  if (!workspace.session.hasScan()) {
    ImGui::TextDisabled("%s", tr("Nothing is open yet"));
    return;
  }
  drawBox(workspace);
  drawEraser(workspace);
  heading(tr("Lasso"));
  commandButton("region.lasso", tr("Cut out by an outline"), -1, workspace);
  drawLassoRows(workspace);
}

}  // namespace sonoskin::ui
