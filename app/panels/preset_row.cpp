#include "app/panels/preset_row.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "app/panels/question_box.h"
#include "app/texts/texts.h"
#include "app/widgets/widget_rects.h"
#include "core/pipeline/presets.h"

namespace sonoskin::ui {
namespace {

void explain(std::string_view help) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
  ImGui::TextUnformatted((capitalised(tr(help)) + ".").c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool drawOurs(Parameters& parameters, const Preset* current) {
  bool chosen = false;
  for (const Preset& preset : presets()) {
    if (ImGui::Selectable(presetTitle(preset.name).c_str(), &preset == current) && &preset != current) {
      applyPreset(preset, parameters);
      chosen = true;
    }
    noteWidget("preset." + std::string(preset.name));
    explain(preset.help);
  }
  return chosen;
}

bool drawTheirs(const std::vector<UserPreset>& presets, Parameters& parameters, const UserPreset* current) {
  bool chosen = false;
  if (!presets.empty()) ImGui::Separator();
  for (const UserPreset& preset : presets) {
    if (ImGui::Selectable((preset.name + "##own").c_str(), &preset == current) && &preset != current) {
      applyUserPreset(preset, parameters);
      chosen = true;
    }
    noteWidget("preset.own." + preset.name);
  }
  return chosen;
}

void drawKeeping(Workspace& w, const UserPreset* current) {
  ImGui::Separator();
  if (ImGui::Selectable(tr("Save as preset..."))) w.presetName = current ? current->name : std::string();
  noteWidget("preset.save");
  if (!current) return;
  const std::string forget = trf("Delete \"{}\"", current->name);
  const bool gone = ImGui::Selectable(forget.c_str());
  noteWidget("preset.delete");
  if (!gone) return;
  w.presets->erase(w.presets->begin() + (current - w.presets->data()));
  writeUserPresets(presetsFile(), *w.presets);
}

}  // namespace

FieldsEdit presetRow(Workspace& w, Parameters& parameters) {
  beginRow(tr("Preset"));
  if (!w.presets) w.presets = readUserPresets(presetsFile());
  const Preset* ours = matchingPreset(parameters);
  const UserPreset* theirs = ours ? nullptr : matchingUserPreset(*w.presets, parameters);
  const std::string title = ours ? presetTitle(ours->name) : theirs ? theirs->name : tr("Your own");
  if (ImGui::BeginCombo("##preset", title.c_str(), ImGuiComboFlags_HeightLarge)) {
    bool chosen = drawOurs(parameters, ours);
    chosen |= drawTheirs(*w.presets, parameters, theirs);
    drawKeeping(w, theirs);
    ImGui::EndCombo();
    return {chosen, chosen};
  }
  noteWidget("preset");
  explain(ours ? ours->help : "parameters that are no preset's; they can be saved as one here");
  return {};
}

void drawPresetName(Workspace& w) {
  if (!w.presetName) return;
  const std::string title = std::string(tr("Save as preset")) + "###presetName";
  const auto type = [&w] {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##name", tr("Name"), &*w.presetName);
    noteWidget("preset.name");
    ImGui::Spacing();
  };
  const auto keep = [&w] {
    const std::string name = *std::exchange(w.presetName, std::nullopt);
    if (name.empty()) return;
    keepPreset(*w.presets, name, w.session.parameters());
    writeUserPresets(presetsFile(), *w.presets);
  };
  drawQuestionBox(
      {title.c_str(), tr("A preset keeps how surfaces are found and fitted; not what belongs to a scan."),
       type},
      {{tr("Save"), "preset.keep", keep}, {tr("Cancel"), "preset.cancel", [&w] { w.presetName.reset(); }}});
}

}  // namespace sonoskin::ui
