#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/panels/preset_row.h"
#include "app/theme.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"

namespace sonoskin::ui {
namespace {

using Names = std::vector<std::string_view>;

// The few that a person turns for a scan; the others are set once for a machine, if ever.
const Names kFirst{"isoValue", "isoShare", "lowPass", "beta"};

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
  applyEdit(workspace, parameters, edit);
}

}  // namespace sonoskin::ui
