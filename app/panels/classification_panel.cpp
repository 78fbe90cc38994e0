#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string_view>

#include "app/panels/panels.h"
#include "app/theme.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"

namespace sonoskin::ui {
namespace {

// The four that a person turns; the others are set once for a machine, if ever.
constexpr std::array<std::string_view, 4> kFirst{"alpha", "beta", "gamma", "isoValue"};

void apply(Workspace& workspace, const Parameters& parameters, FieldsEdit edit) {
  if (edit.changed) workspace.session.edit(parameters);
  if (edit.finished) workspace.session.commitEdit();
}

std::string sentence(std::string_view text) {
  std::string result(text);
  if (!result.empty()) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  return result;
}

template <class Options>
FieldsEdit drawGroup(const Group& group, Options& options, const Rows& rows) {
  const std::string title = sentence(group.name) + "##" + std::string(group.name);
  const bool open = ImGui::CollapsingHeader(title.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", sentence(group.help).c_str());
  FieldsEdit edit;
  if (!open || !beginFields(title.c_str())) return edit;
  edit = editFields(group.name, options, rows);
  endFields();
  return edit;
}

}  // namespace

void drawClassificationPanel(Workspace& workspace) {
  section("Classification");
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  if (beginFields("first")) {
    edit = editFields("classification", parameters.classification, {kFirst, false});
    endFields();
  }
  const double found = workspace.session.results().isoValue;
  if (parameters.classification.isoValue == 0 && found > 0) {
    ImGui::TextDisabled("Iso value 0: found from the volume, %.3f", found);
  }
  apply(workspace, parameters, edit);
}

void drawMorePanel(Workspace& workspace) {
  section("More parameters");
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  bool simulate = false;
  groups(
      [&](const Group& group, auto& options) {
        const bool classification = group.name == "classification";
        edit |= drawGroup(group, options, classification ? Rows{kFirst, true} : Rows{});
        if (group.name == "phantom" && ImGui::Button("Simulate again", {-1, 0})) simulate = true;
      },
      parameters);
  apply(workspace, parameters, edit);
  if (simulate) workspace.session.openPhantom();
}

}  // namespace sonoskin::ui
