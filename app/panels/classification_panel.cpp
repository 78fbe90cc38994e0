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

// The rows of a group under its heading; `below` is drawn after them.
template <class Options, class Below>
FieldsEdit drawGroup(const Group& group, Options& options, const Rows& rows, const Below& below) {
  const std::string title = sentence(group.name);
  FieldsEdit edit;
  if (!foldout(title.c_str(), sentence(group.help).c_str())) return edit;
  if (beginFields(title.c_str())) {
    edit = editFields(group.name, options, rows);
    endFields();
  }
  below();
  ImGui::Dummy({0, 4 * unit()});
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
        const Rows rows = group.name == "classification" ? Rows{kFirst, true} : Rows{};
        edit |= drawGroup(group, options, rows, [&] {
          if (group.name == "phantom") simulate = ImGui::Button("Simulate again", {-1, 0});
        });
      },
      parameters);
  apply(workspace, parameters, edit);
  if (simulate) workspace.session.openPhantom();
}

}  // namespace sonoskin::ui
