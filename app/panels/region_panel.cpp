#include <fmt/format.h>
#include <imgui.h>

#include "app/document/crop_box.h"
#include "app/panels/panels.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

// A button of a command, over `width`; in the accent's colour while the command is on.
void commandButton(const char* id, const char* title, float width, Workspace& workspace) {
  const Command& c = command(id);
  const bool on = c.checked && c.checked(workspace);
  const DisabledIf disabled(!isEnabled(c, workspace));
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(kAccent.x, kAccent.y, kAccent.z, 0.42f));
  if (ImGui::Button(title, {width, 0})) c.run(workspace);
  if (on) ImGui::PopStyleColor();
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
  const bool open = foldout("Crop box", "Only what lies in the box becomes surface.");
  if (!open) return;
  drawSides(workspace);
  const float width = halfWidth();
  commandButton("region.box", "Show in the views", width, workspace);
  ImGui::SameLine();
  commandButton("region.resetBox", "Whole volume", width, workspace);
}

void drawEraser(Workspace& workspace) {
  const float width = halfWidth();
  commandButton("region.erase", "Erase", width, workspace);
  ImGui::SameLine();
  commandButton("region.clear", "Bring everything back", width, workspace);
  const std::size_t voxels = workspace.session.erased().voxels();
  if (isChosen(workspace.view, Tool::eraser) && beginFields("eraser")) {
    beginRow("Radius");
    const double least = kLeastBrush, most = kMostBrush;
    ImGui::SliderScalar("##radius", ImGuiDataType_Double, &workspace.view.brushRadius, &least, &most,
                        "%.1f mm", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    noteWidget("region.radius");
    endFields();
    ImGui::TextDisabled("Drag in a slice; with Ctrl it brings back. Keys [ and ]");
  }
  if (voxels > 0) {
    const glm::dvec3& spacing = workspace.session.scan().volume->geometry.spacing;
    const double cubicCentimetres = double(voxels) * spacing.x * spacing.y * spacing.z / 1000;
    fact("Erased", fmt::format("{:.2f} cm³", cubicCentimetres));
  }
}

}  // namespace

void drawRegionPanel(Workspace& workspace) {
  section("Region");
  if (!workspace.session.hasScan()) {
    ImGui::TextDisabled("Nothing is open yet");
    return;
  }
  drawEraser(workspace);
  commandButton("region.lasso", "Cut out by an outline", ImGui::GetContentRegionAvail().x, workspace);
  drawLassoRows(workspace);
  drawBox(workspace);
}

}  // namespace sonoskin::ui
