// The transfer function of a translucent volume: which it is, its curve, and the person's own ones.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/panels/panels.h"
#include "app/panels/preset_row.h"
#include "app/panels/view_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/transfer_editor.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/own_transfers.h"
#include "core/base/error.h"

namespace sonoskin::ui {
namespace {

float levelOf(const Workspace& w) { return static_cast<float>(shownLevel(w.view, w.session.results())); }

// Does what may fail; what went wrong is told.
template <class F>
bool tryTo(Workspace& workspace, F&& action) {
  try {
    action();
    return true;
  } catch (const Error& error) {
    workspace.toasts.add(error.what(), true);
  }
  return false;
}

void choose(VolumeShow& show, const std::string& name, std::optional<LevelledTransfer> own) {
  show.colours = name;
  show.own = std::move(own);
  show.changed = false;
  show.selected = -1;
}

std::string shownName(const VolumeShow& show) {
  const std::string name = findTransferPreset(show.colours) ? presetTitle(show.colours) : show.colours;
  return show.changed ? name + tr(", changed") : name;
}

// The list; whether the present function is to be saved.
bool drawList(Workspace& workspace) {
  VolumeShow& show = workspace.view.volume;
  for (const TransferPreset& preset : transferPresets()) {
    if (ImGui::Selectable(presetTitle(preset.name).c_str(), show.colours == preset.name && !show.changed))
      choose(show, preset.name, {});
    noteWidget(std::string("colours.") + preset.name);
  }
  ImGui::Separator();
  for (const std::string& name : ownTransfers()) {
    if (ImGui::Selectable(name.c_str(), show.colours == name && !show.changed))
      tryTo(workspace, [&] { choose(show, name, ownTransfer(name)); });
    noteWidget("colours." + name);
  }
  const bool saves = ImGui::Selectable(tr("Save as..."));
  noteWidget("colours.save");
  if (findTransferPreset(show.colours)) return saves;
  if (ImGui::Selectable(tr("Delete these colours"))) {
    forgetTransfer(show.colours);
    choose(show, transferPresets().front().name, {});
  }
  noteWidget("colours.delete");
  return saves;
}

// A name for the present function.
void drawNaming(Workspace& workspace) {
  VolumeShow& show = workspace.view.volume;
  if (!ImGui::BeginPopup("colours name")) return;
  ImGui::TextUnformatted(tr("Save the colours as"));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(200 * unit());
  const bool entered = ImGui::InputText("##name", &show.name, ImGuiInputTextFlags_EnterReturnsTrue);
  noteWidget("colours.name");
  ImGui::SameLine();
  const bool pressed = ImGui::Button(tr("Save"));
  noteWidget("colours.keep");
  const LevelledTransfer made{show.transfer(levelOf(workspace)), levelOf(workspace)};
  if ((entered || pressed) && tryTo(workspace, [&] { keepTransfer(show.name, made); })) {
    choose(show, show.name, made);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

void drawColoursRow(Workspace& workspace) {
  VolumeShow& show = workspace.view.volume;
  beginRow(tr("Colours"));
  ImGui::SetNextItemWidth(-1);
  bool saves = false;
  if (ImGui::BeginCombo("##colours", shownName(show).c_str(), ImGuiComboFlags_HeightLarge)) {
    saves = drawList(workspace);
    ImGui::EndCombo();
  } else {
    noteWidget("colours");
  }
  if (saves) {
    show.name = findTransferPreset(show.colours) ? "" : show.colours;
    ImGui::OpenPopup("colours name");
  }
  drawNaming(workspace);
}

namespace {

void drawEditor(Workspace& workspace) {
  VolumeShow& show = workspace.view.volume;
  const float level = levelOf(workspace);
  TransferFunction transfer = show.transfer(level);
  const TransferPlot plot{workspace.histogram.of(shownVolume(workspace)), level};
  if (!editTransfer(transfer, plot, show.selected).changed) return;
  show.own = LevelledTransfer{transfer, level};
  show.changed = true;
}

}  // namespace

// At first over the parameters, so that the picture that it changes is in sight.
void drawColoursWindow(Workspace& workspace) {
  ViewState& view = workspace.view;
  if (!view.volume.edited || !workspace.session.hasScan() || view.content != SpaceContent::volume ||
      view.volumeStyle != VolumeStyle::translucent)
    return;
  const float width = sidePanelWidth() - 16 * unit();
  ImGui::SetNextWindowPos({8 * unit(), ImGui::GetMainViewport()->Size.y - 140 * unit()},
                          ImGuiCond_FirstUseEver, {0, 1});
  ImGui::SetNextWindowSize({width, 0});
  const std::string title = std::string(tr("Colours of the volume")) + "###colours";
  if (ImGui::Begin(
          title.c_str(), &view.volume.edited,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    if (beginFields("colours rows")) {
      drawColoursRow(workspace);
      endFields();
    }
    drawEditor(workspace);
  }
  ImGui::End();
}

}  // namespace sonoskin::ui
