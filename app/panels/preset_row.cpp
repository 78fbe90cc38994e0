#include "app/panels/preset_row.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>

#include "app/widgets/widget_rects.h"
#include "core/pipeline/presets.h"

namespace sonoskin::ui {
namespace {

void explain(std::string_view help) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
  ImGui::TextUnformatted(
      fmt::format("{}{}.", char(std::toupper(static_cast<unsigned char>(help[0]))), help.substr(1)).c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

std::string presetTitle(std::string_view name) {
  std::string title(name);
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

FieldsEdit presetRow(Parameters& parameters) {
  beginRow("Preset");
  const Preset* current = matchingPreset(parameters);
  FieldsEdit edit;
  const bool open = ImGui::BeginCombo("##preset", current ? presetTitle(current->name).c_str() : "Your own",
                                      ImGuiComboFlags_HeightLarge);
  if (open) {
    for (const Preset& preset : presets()) {
      if (ImGui::Selectable(presetTitle(preset.name).c_str(), &preset == current) && &preset != current) {
        applyPreset(preset, parameters);
        edit = {true, true};
      }
      noteWidget("preset." + std::string(preset.name));
      explain(preset.help);
    }
    ImGui::EndCombo();
    return edit;
  }
  noteWidget("preset");
  explain(current ? current->help : "parameters that are no preset's");
  return edit;
}

}  // namespace sonoskin::ui
