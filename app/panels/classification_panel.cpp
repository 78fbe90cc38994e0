#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/panels/preset_row.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"

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

// The iso-value that was found, and how far it goes down and up from place to place.
std::string automaticText(const Results& results) {
  const IsoRange& range = results.isoRange;
  if (range.most - range.least < 0.015) return fmt::format(", {:.2f}", results.isoValue);
  return fmt::format(", {:.2f} ({:.2f} to {:.2f})", results.isoValue, range.least, range.most);
}

// What it was measured from.
std::string explanationOf(const Results& results, double share) {
  const IsoRange& range = results.isoRange;
  std::string text = fmt::format(
      "Found from this scan: the fluid's grey is {:.2f}, that of the steepest edges {:.2f}; the iso-value "
      "lies "
      "{:.0f} % of the way, {:.2f} in all and {:.2f} to {:.2f} from place to place.",
      range.fluid, range.edge, 100 * share, results.isoValue, range.least, range.most);
  if (const EdgeProfile& edge = results.edge; edge.width > 0)
    text += fmt::format(" Across the surface the grey rises from {:.2f} to {:.2f} within {:.1f} mm.",
                        edge.dark, edge.bright, edge.width);
  return text + " Drag to set one iso-value for the whole scan from there.";
}

// The words of the first rows.
RowText firstRowText(const Workspace& workspace, const Parameters& parameters, std::string_view field) {
  RowText text = useOf(parameters, "classification")(field);
  if (field == "lowPass") text.label = "Noise filter";
  if (field == "beta") text.label = "Smoothing";
  if (field == "isoValue" && parameters.classification.isoValue == 0) {
    text.shown = "automatic";
    const Results& results = workspace.session.results();
    if (const double found = results.isoValue; found > 0) {
      text.shown += automaticText(results);
      text.found = explanationOf(results, parameters.classification.isoShare);
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
