// The bars over the views: what each of them shows.
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/panels/grey_rows.h"
#include "app/panels/measure_rows.h"
#include "app/panels/panels.h"
#include "app/panels/view_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

using Names = std::initializer_list<const char*>;

constexpr float kMargin = 3;       // around the buttons
constexpr float kTitleRoom = 175;  // pixels without scale that a view's title takes beside its bar

template <class E>
bool choose(const char* id, Names names, E& value) {
  int index = static_cast<int>(value);
  const bool changed = textSegments(id, names, index);
  value = static_cast<E>(index);
  return changed;
}

// The views are dark in every appearance: so are the bars over them.
class OverPicture {
 public:
  OverPicture() {
    ImGui::PushStyleColor(ImGuiCol_Text, colours().text);
    ImGui::PushStyleColor(ImGuiCol_PopupBg, colours().ground);  // of hints
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.20f, 0.21f, 0.22f, 0.85f));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImVec4(0.28f, 0.30f, 0.32f, 0.95f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, ImVec4(0.16f, 0.17f, 0.18f, 1));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(7 * unit(), 2 * unit()));
    ImGui::PushFont(smallFont());
  }
  ~OverPicture() {
    ImGui::PopFont();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(5);
  }
  OverPicture(const OverPicture&) = delete;
  OverPicture& operator=(const OverPicture&) = delete;

 private:
  InAppearance dark_{Appearance::dark};
};

bool moreButton(const char* name) {
  const bool pressed = ImGui::Button("⋯###more", {26 * unit(), 0});
  noteWidget(name);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr("More of what this view shows"));
  return pressed;
}

float moreWidth() { return 26 * unit(); }
float gap() { return 6 * unit(); }

// ---- slices

constexpr Names kLayers{"Raw", "Classified", "Thinned"};

void drawMarks(ViewState& view) {
  const auto box = [](const char* name, const char* id, bool& shown) {
    ImGui::Checkbox(tr(name), &shown);
    noteWidget(id);
  };
  box("Mark the surface voxels", "view.surfaceVoxels", view.surfaceVoxels);
  box("Classified volume in colour", "view.tint", view.classifiedTint);
  box("Points", "view.points", view.slicePoints);
  box("Contour of the surface", "view.contour", view.meshContour);
  box("Show the crop box", "view.cropBox", view.cropBox);
  box("Zoom all slices together", "view.linkedZoom", view.linkedZoom);
}

void drawSliceBar(ViewState& view, bool wide) {
  if (wide) {
    choose("view.layer", kLayers, view.layer);
    ImGui::SameLine(0, gap());
  }
  if (moreButton("view.slice.more")) ImGui::OpenPopup("more");
}

void drawSliceMore(Workspace& workspace, bool wide) {
  if (!wide) choose("view.layer", kLayers, workspace.view.layer);
  drawMarks(workspace.view);
  ImGui::Separator();
  drawGreyRows(workspace);
  ImGui::Separator();
  drawMeasureRows(workspace);
}

float sliceBarWidth(bool wide) { return (wide ? textSegmentsWidth(kLayers) + gap() : 0) + moreWidth(); }

// ---- 3D

constexpr Names kContents{"Volume", "Mesh"}, kStyles{"Surface", "Translucent", "Maximum"},
    kLooks{"Clay", "Skin"};

void chooseContent(Workspace& workspace) {
  ViewState& view = workspace.view;
  SpaceContent content = view.content;
  if (!choose("view.content", kContents, content)) return;
  if (content == SpaceContent::mesh && !workspace.session.results().mesh)
    workspace.toasts.add(tr("There is no mesh yet: press Reconstruct surface."), false);
  else
    view.content = content;
}

void chooseStyle(ViewState& view) {
  if (view.content == SpaceContent::volume)
    choose("view.volumeStyle", kStyles, view.volumeStyle);
  else
    choose("view.meshStyle", kLooks, view.meshStyle);
}

// Of whichever has more to choose: no button moves when the other is shown.
float stylesWidth() { return std::max(textSegmentsWidth(kStyles), textSegmentsWidth(kLooks)); }

void drawSpaceBar(Workspace& workspace, bool wide) {
  chooseContent(workspace);
  ImGui::SameLine(0, gap());
  if (wide) {
    const float left = ImGui::GetCursorPosX();
    chooseStyle(workspace.view);
    ImGui::SameLine(left + stylesWidth() + gap());
  }
  if (moreButton("view.space.more")) ImGui::OpenPopup("more");
}

float spaceBarWidth(bool wide) {
  const float style = wide ? stylesWidth() + gap() : 0;
  return textSegmentsWidth(kContents) + gap() + style + moreWidth();
}

void drawMeshMore(Workspace& workspace) {
  ImGui::Checkbox(tr("Mark what was not measured"), &workspace.view.unmeasured);
  noteWidget("view.unmeasured");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", tr("Greyed: closed holes, and the border, where points grow sparse."));
  const Command& parts = command("surface.parts");
  const DisabledIf none(!isEnabled(parts, workspace));
  bool shown = workspace.view.parts;
  if (ImGui::Checkbox(tr(parts.title), &shown)) parts.run(workspace);
  noteWidget(parts.id);
}

void drawSpaceMore(Workspace& workspace, bool wide) {
  drawComparedRows(workspace);
  if (!wide) chooseStyle(workspace.view);
  if (workspace.view.content == SpaceContent::volume)
    drawVolumeRows(workspace);
  else
    drawMeshMore(workspace);
  ImGui::Separator();
  drawClipRows(workspace);
}

// ---- both

void drawButtons(Workspace& workspace, const ShownPane& place, bool wide) {
  const OverPicture dark;
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  // What a long title says below the bar is not to be seen through it.
  ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                                            IM_COL32(6, 7, 9, 235), 4 * unit());
  ImGui::SetCursorPos({kMargin * unit(), kMargin * unit()});
  if (place.pane == Pane::oblique) {
    drawObliqueNumbers(workspace);
    ImGui::SameLine(0, gap());
  }
  if (place.pane == Pane::space)
    drawSpaceBar(workspace, wide);
  else
    drawSliceBar(workspace.view, wide);
}

void drawMore(Workspace& workspace, const ShownPane& place, bool wide) {
  const float width = 290 * unit();
  ImGui::SetNextWindowPos({place.corner.x + place.size.x - 8 * unit(), place.corner.y + 34 * unit()},
                          ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowSize({width, 0});
  if (!ImGui::BeginPopup("more")) return;
  if (place.pane == Pane::space)
    drawSpaceMore(workspace, wide);
  else
    drawSliceMore(workspace, wide);
  ImGui::EndPopup();
}

ImVec2 barSize(const ShownPane& place, bool wide) {
  const OverPicture dark;
  float width = place.pane == Pane::space ? spaceBarWidth(wide) : sliceBarWidth(wide);
  if (place.pane == Pane::oblique) width += obliqueNumbersWidth() + gap();
  return {width + 2 * kMargin * unit(), ImGui::GetFrameHeight() + 2 * kMargin * unit()};
}

// A window of its own over the view: what is below does not see the mouse.
void drawBar(Workspace& workspace, const ShownPane& place) {
  const bool wide = place.size.x - barSize(place, true).x >= kTitleRoom * unit();
  const ImVec2 size = barSize(place, wide);
  ImGui::SetCursorScreenPos(
      {place.corner.x + place.size.x - size.x - 4 * unit(), place.corner.y + 5 * unit()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushID(int(place.pane));
  ImGui::BeginChild(
      "bar", size, false,
      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  drawButtons(workspace, place, wide);
  drawMore(workspace, place, wide);
  ImGui::EndChild();
  ImGui::PopID();
}

}  // namespace

void drawViewBars(Workspace& workspace, std::span<const ShownPane> places) {
  if (!workspace.session.hasScan()) return;
  for (const ShownPane& place : places)
    if (!place.compared) drawBar(workspace, place);
}

}  // namespace sonoskin::ui
