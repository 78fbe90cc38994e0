#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/panels/preset_row.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"

namespace sonoskin::ui {
namespace {

using Names = std::vector<std::string_view>;

// What is solved, and what a person turns for a scan; the others are set once for a machine, if ever.
const Names kFirst{"isoValue", "alpha", "beta", "gamma", "isoShare", "lowPass"};

// Block: parameters of the classification that belong together.
struct Block {
  const char* title;
  Names names;
};
const std::array<Block, 4> kBlocks{
    Block{"Equation", {"formulation", "target", "gradientFloor", "gradientReference"}},
    Block{"Values and edges", {"rawShare", "gradientSource", "noiseFloor", "farthest"}},
    Block{"Along the surface", {"tangentialLength", "directionScale"}},
    Block{"Thesis' formulations", {"curl", "rescale"}}};

// What no block names: a new parameter has a row without a word here.
Names namedAbove() {
  Names names = kFirst;
  for (const Block& block : kBlocks) names.insert(names.end(), block.names.begin(), block.names.end());
  return names;
}

// What it was measured from.
std::string explanationOf(const Results& results, double share) {
  const IsoRange& range = results.isoRange;
  std::string text = trf(
      "Found from this scan: the fluid's grey is {:.2f}, that of the steepest edges {:.2f}; the iso-value "
      "lies {:.0f} % of the way, {:.2f} in all and {:.2f} to {:.2f} from place to place.",
      range.fluid, range.edge, 100 * share, results.isoValue, range.least, range.most);
  if (const EdgeProfile& edge = results.edge; edge.width > 0)
    text += " " + trf("Across the surface the grey rises from {:.2f} to {:.2f} within {:.1f} mm.", edge.dark,
                      edge.bright, edge.width);
  return text + " " + tr("Drag to set one iso-value for the whole scan from there.");
}

RowText rowText(const Workspace& workspace, const Parameters& parameters, std::string_view field) {
  RowText text = useOf(parameters, "classification")(field);
  if (field == "isoValue" && parameters.classification.isoValue == 0) {
    text.shown = tr("auto");
    const Results& results = workspace.session.results();
    if (const double found = results.isoValue; found > 0) {
      text.shown += fmt::format(" {:.2f}", found);
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

FieldsEdit drawBlocks(ClassificationOptions& options, const std::function<RowText(std::string_view)>& text) {
  FieldsEdit edit;
  for (const Block& block : kBlocks) {
    heading(tr(block.title));
    if (!beginFields(block.title)) continue;
    edit |= drawRows(options, block.names, text);
    endFields();
  }
  const Names above = namedAbove();
  return edit |= groupRows(tr("Solver"), "classification", options, {above, true, text});
}

}  // namespace

void drawClassificationPanel(Workspace& workspace) {
  Parameters parameters = workspace.session.parameters();
  const auto text = [&](std::string_view field) { return rowText(workspace, parameters, field); };
  FieldsEdit edit;
  if (beginFields("first")) {
    edit = presetRow(workspace, parameters);
    edit |= drawRows(parameters.classification, kFirst, text);
    endFields();
  }
  drawPresetName(workspace);
  edit |= drawBlocks(parameters.classification, text);
  edit |= groupRows(tr("Less speckle before"), "enhancement", parameters.enhancement,
                    {{}, false, useOf(parameters, "enhancement")});
  applyEdit(workspace, parameters, edit);
}

}  // namespace sonoskin::ui
