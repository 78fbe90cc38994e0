#include <fmt/format.h>
#include <imgui.h>

#include "app/document/crop_box.h"
#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
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
    ImGui::SetTooltip("%s%s", tr(c.title), key.empty() ? "" : fmt::format("   {}", key).c_str());
  }
}

float halfWidth() { return 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x); }

// One side of the crop box: where it lies along its axis, as the slices' titles count.
FieldsEdit editSide(const Side& side, RegionOptions& options, const Geometry& g) {
  const std::string name = fmt::format("region.{}.{}", "ijk"[side.axis], side.high ? "high" : "low");
  const char* help = side.high
                         ? "nothing beyond this is surface; the box's sides can be dragged in the slices"
                         : "nothing before this is surface; the box's sides can be dragged in the slices";
  const std::string label = trf(side.high ? "to" : "Along {}, from", "ijk"[side.axis]);
  const double most = sideAt({side.axis, true}, {}, g), standing = sideAt(side, options, g);
  double mm = standing;
  const FieldsEdit edit = editField(FieldRow{name, Field{"side", help, "mm"}, {.label = label}}, mm,
                                    side.high ? most : 0.0, Range{0.0, most});
  if (mm != standing) moveSide(side, mm, options, g);
  return edit;
}

void drawSides(Workspace& workspace) {
  const Geometry& g = workspace.session.scan().volume->geometry;
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  if (beginFields("box")) {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool high : {false, true}) edit |= editSide({axis, high}, parameters.region, g);
    endFields();
  }
  applyEdit(workspace, parameters, edit);
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
  const FieldRow row{"region.radius", Field{"radius", "how far around the mouse the eraser reaches", "mm"}};
  editField(row, workspace.view.brushRadius, ViewState().brushRadius, Range{kLeastBrush, kMostBrush, true});
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
