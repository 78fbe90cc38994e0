#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cctype>
#include <span>
#include <string_view>
#include <vector>

#include "app/panels/panels.h"
#include "app/panels/preset_row.h"
#include "app/theme.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "core/pipeline/parameter_use.h"

namespace sonoskin::ui {
namespace {

using Names = std::vector<std::string_view>;

// The few that a person turns for a scan; the others are set once for a machine, if ever.
const Names kFirst{"isoValue", "lowPass", "beta"};

// What the panel of the surface shows of the reconstruction's parameters.
constexpr std::array<std::string_view, 1> kOnSurfacePanel{"smoothness"};

// Block: parameters of the classification that belong together, under "Advanced".
struct Block {
  const char* title;
  Names names;
};
const std::array<Block, 4> kBlocks{
    Block{"Equation", {"formulation", "alpha", "gamma", "target", "gradientFloor", "gradientReference"}},
    Block{"Values and edges", {"rawShare", "gradientSource", "noiseFloor", "farthest"}},
    Block{"Along the surface", {"tangentialLength", "directionScale"}},
    Block{"Thesis' formulations", {"curl", "rescale"}}};

// What no block names: a new parameter has a row without a word here.
Names namedAbove() {
  Names names = kFirst;
  for (const Block& block : kBlocks) names.insert(names.end(), block.names.begin(), block.names.end());
  return names;
}

void apply(Workspace& workspace, const Parameters& parameters, FieldsEdit edit) {
  if (edit.changed) workspace.session.edit(parameters);
  if (edit.finished) workspace.session.commitEdit();
}

std::string sentence(std::string_view text) {
  std::string result(text);
  if (!result.empty()) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  return result;
}

// Greys the parameters that have no effect beside the others' values, and says why.
auto useOf(const Parameters& parameters, std::string_view group) {
  return [&parameters, group](std::string_view field) {
    return RowText{.unused = std::string(unusedBecause(parameters, group, field))};
  };
}

// The words of the first rows.
RowText firstRowText(const Workspace& workspace, const Parameters& parameters, std::string_view field) {
  RowText text = useOf(parameters, "classification")(field);
  if (field == "lowPass") text.label = "Noise filter";
  if (field == "beta") text.label = "Smoothing";
  if (field == "isoValue" && parameters.classification.isoValue == 0) {
    text.shown = "automatic";
    if (const double found = workspace.session.results().isoValue; found > 0) {
      text.shown += fmt::format(", {:.2f}", found);
      text.grab = found;  // whoever drags it goes on from there
    }
  }
  return text;
}

// Rows in the order of `names`, between beginFields() and endFields().
FieldsEdit drawRows(ClassificationOptions& options, const Names& names,
                    const std::function<RowText(std::string_view)>& text) {
  FieldsEdit edit;
  for (const std::string_view& name : names)
    edit |= editFields("classification", options, {std::span(&name, 1), false, text});
  return edit;
}

FieldsEdit drawAdvanced(Parameters& parameters) {
  FieldsEdit edit;
  if (!foldout("Advanced", "The equation that finds the surfaces.")) return edit;
  const auto text = useOf(parameters, "classification");
  for (const Block& block : kBlocks) {
    ImGui::TextDisabled("%s", block.title);
    if (!beginFields(block.title)) continue;
    edit |= drawRows(parameters.classification, block.names, text);
    endFields();
  }
  ImGui::TextDisabled("Solver");
  const Names above = namedAbove();
  if (beginFields("rest")) {
    edit |= editFields("classification", parameters.classification, {above, true, text});
    endFields();
  }
  ImGui::Dummy({0, 4 * unit()});
  return edit;
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

// How far the points were moved from the echo's edge to the skin.
void drawEchoOffset(const Results& results) {
  if (results.points && results.echoOffset != 0)
    ImGui::TextDisabled("Points moved %.2f mm inward, onto the skin", results.echoOffset);
}

}  // namespace

void drawClassificationPanel(Workspace& workspace) {
  section("Classification");
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  if (beginFields("first")) {
    edit = presetRow(parameters);
    edit |= drawRows(parameters.classification, kFirst,
                     [&](std::string_view field) { return firstRowText(workspace, parameters, field); });
    endFields();
  }
  edit |= drawAdvanced(parameters);
  apply(workspace, parameters, edit);
}

void drawMorePanel(Workspace& workspace) {
  section("More parameters");
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  bool simulate = false;
  groups(
      [&](const Group& group, auto& options) {
        if (group.name == "classification") return;  // has a panel of its own
        Rows rows{{}, false, useOf(parameters, group.name)};
        if (group.name == "reconstruction") rows = {kOnSurfacePanel, true, rows.text};
        edit |= drawGroup(group, options, rows, [&] {
          if (group.name == "surface") drawEchoOffset(workspace.session.results());
          if (group.name == "phantom") simulate = ImGui::Button("Simulate again", {-1, 0});
        });
      },
      parameters);
  apply(workspace, parameters, edit);
  if (simulate) workspace.session.openPhantom();
}

}  // namespace sonoskin::ui
