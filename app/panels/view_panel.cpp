#include <imgui.h>

#include "app/panels/panels.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

template <class E>
bool chooseSegment(const char* id, std::initializer_list<const char*> names, E& value) {
  int index = static_cast<int>(value);
  const bool changed = segments(id, names, index);
  value = static_cast<E>(index);
  return changed;
}

void rowLabel(const char* text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text);
  ImGui::TableNextColumn();
}

void drawVolumeRows(ViewState& view, const Results& results) {
  rowLabel("Shown");
  chooseSegment("view.volumeLayer", {"Raw", "Classified"}, view.volumeLayer);
  rowLabel("Style");
  chooseSegment("view.volumeStyle", {"Surface", "Translucent"}, view.volumeStyle);
  rowLabel("Level");
  const float width = ImGui::GetContentRegionAvail().x;
  float level = static_cast<float>(shownLevel(view, results));
  ImGui::SetNextItemWidth(width);
  if (ImGui::SliderFloat("##level", &level, 0.01f, 0.99f, view.volumeLevel ? "%.2f" : "%.2f (found)",
                         ImGuiSliderFlags_AlwaysClamp)) {
    view.volumeLevel = double(level);
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
    ImGui::SetTooltip("Grey value at which the rays stop.\nRight click: the value found from the volume.");
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) view.volumeLevel.reset();
  }
}

// The wall of the uterus lies between probe and face: without the crop it hides what one wants to see.
void drawCrop(ViewState& view) {
  rowLabel("");
  ImGui::Checkbox("Only around the found surface", &view.crop);
  noteWidget("view.crop");
}

}  // namespace

void drawViewPanel(Workspace& workspace) {
  section("View");
  const DisabledIf disabled(!workspace.session.hasScan());
  ViewState& view = workspace.view;
  const Results& results = workspace.session.results();
  if (!ImGui::BeginTable("view", 2)) return;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed, 54 * unit());
  ImGui::TableSetupColumn("widget", ImGuiTableColumnFlags_WidthStretch);
  rowLabel("Slices");
  chooseSegment("view.layer", {"Raw", "Classified", "Thinned"}, view.layer);
  rowLabel("");
  ImGui::Checkbox("Mark the surface voxels", &view.surfaceVoxels);
  noteWidget("view.surfaceVoxels");
  rowLabel("3D");
  SpaceContent content = view.content;
  if (chooseSegment("view.content", {"Volume", "Mesh"}, content)) {
    if (content == SpaceContent::volume || results.mesh) view.content = content;
    if (content == SpaceContent::mesh && !results.mesh) {
      workspace.toasts.add("There is no mesh yet: press Reconstruct surface.", false);
    }
  }
  if (view.content == SpaceContent::volume) {
    drawVolumeRows(view, results);
    drawCrop(view);
  } else {
    rowLabel("Look");
    chooseSegment("view.meshStyle", {"Clay", "Skin"}, view.meshStyle);
    rowLabel("");
    ImGui::Checkbox("Mark what was not measured", &view.unmeasured);
    noteWidget("view.unmeasured");
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("Greyed: closed holes, and the border, where points grow sparse.");
    rowLabel("");
    const Command& parts = command("surface.parts");
    const DisabledIf none(!isEnabled(parts, workspace));
    bool shown = view.parts;
    if (ImGui::Checkbox(parts.title, &shown)) parts.run(workspace);
    noteWidget(parts.id);
  }
  ImGui::EndTable();
}

}  // namespace sonoskin::ui
