#include <imgui.h>

#include "app/panels/view_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

void drawLevel(ViewState& view, const Results& results) {
  auto level = static_cast<float>(shownLevel(view, results));
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("##level", &level, 0.01f, 0.99f, view.volumeLevel ? "%.2f" : tr("%.2f (found)"),
                         ImGuiSliderFlags_AlwaysClamp))
    view.volumeLevel = double(level);
  noteWidget("view.level");
  if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
  ImGui::SetTooltip(
      "%s", view.volumeStyle == VolumeStyle::surface
                ? tr("Grey value at which the rays stop.\nRight click: the value found from the volume.")
                : tr("Grey value where skin begins; the colours move with it.\n"
                     "Right click: the value found from the volume."));
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) view.volumeLevel.reset();
}

void chooseLayer(ViewState& view) {
  int index = static_cast<int>(view.volumeLayer);
  if (textSegments("view.volumeLayer", {"Raw", "Classified"}, index)) view.volumeLayer = VolumeLayer(index);
}

void drawTranslucentRows(Workspace& workspace) {
  const Command& edit = command("view.colours");
  bool edits = workspace.view.volume.edited;
  if (ImGui::Checkbox(tr("Edit the colours"), &edits)) edit.run(workspace);
  noteWidget(edit.id);
  ImGui::Checkbox(tr("Shadows"), &workspace.view.volume.shadows);
  noteWidget("view.volumeShadows");
  const DisabledIf none(!workspace.session.results().mesh);
  ImGui::Checkbox(tr("The surface within it"), &workspace.view.volume.mesh);
  noteWidget("view.volumeMesh");
}

}  // namespace

void drawVolumeRows(Workspace& workspace) {
  ViewState& view = workspace.view;
  const bool translucent = view.volumeStyle == VolumeStyle::translucent;
  if (beginFields("volume")) {
    beginRow(tr("Shown"));
    chooseLayer(view);
    if (view.volumeStyle != VolumeStyle::maximum) {
      beginRow(tr("Level"));
      drawLevel(view, workspace.session.results());
    }
    if (translucent) drawColoursRow(workspace);
    endFields();
  }
  if (translucent) drawTranslucentRows(workspace);
  // The wall of the uterus lies between probe and face: without this it hides what one wants to see.
  ImGui::Checkbox(tr("Only around the found surface"), &view.crop);
  noteWidget("view.crop");
}

}  // namespace sonoskin::ui
