#include <imgui.h>

#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"

namespace sonoskin::ui {
namespace {

constexpr double kMostDepth = 100;  // mm

}  // namespace

void drawLassoRows(Workspace& workspace) {
  sentenceText(tr("Draw around it in a slice or in 3D; Ctrl brings back, Shift keeps the inside alone."));
  const DisabledIf away(!isChosen(workspace.view, Tool::lasso));
  if (!beginFields("lasso")) return;
  double& depth = workspace.view.lassoDepth;
  const FieldRow row{
      "region.lassoDepth",
      Field{"depth", "how far behind what is seen first, or to both sides of a slice, is cut out; 0: all",
            "mm"},
      {.shown = depth > 0 ? "" : tr("all")}};
  editField(row, depth, ViewState().lassoDepth, Range{0.0, kMostDepth});
  endFields();
}

}  // namespace sonoskin::ui
