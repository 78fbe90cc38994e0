#include "app/workspace/tool.h"

#include "app/workspace/view_state.h"

namespace sonoskin {

void toggle(Tool& chosen, Tool tool) { chosen = chosen == tool ? Tool::crossHair : tool; }

bool isChosen(const ViewState& view, Tool tool) {
  if (tool == Tool::crossHair) return false;
  return view.sliceTool == tool || view.spaceTool == tool || (tool == Tool::parts && view.parts);
}

void putAway(ViewState& view, Tool tool) {
  for (Tool* chosen : {&view.sliceTool, &view.spaceTool})
    if (*chosen == tool) *chosen = Tool::crossHair;
  if (tool == Tool::parts) view.parts = false;
  if (tool == Tool::measure) view.measureBegun.reset();
}

}  // namespace sonoskin
