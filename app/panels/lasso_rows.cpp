#include <imgui.h>

#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

constexpr double kMostDepth = 100;  // mm

}  // namespace

void drawLassoRows(Workspace& workspace) {
  sentenceText(tr("Draw around it in a slice or in 3D; Ctrl brings back, Shift keeps the inside alone."));
  const DisabledIf away(!isChosen(workspace.view, Tool::lasso));
  if (!beginFields("lasso")) return;
  beginRow("Depth");
  const double least = 0;
  ImGui::SliderScalar("##lassoDepth", ImGuiDataType_Double, &workspace.view.lassoDepth, &least, &kMostDepth,
                      workspace.view.lassoDepth > 0 ? "%.0f mm" : tr("all"), ImGuiSliderFlags_AlwaysClamp);
  noteWidget("region.lassoDepth");
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    ImGui::SetTooltip("%s",
                      tr("How far behind what is seen first, or to both sides of a slice, is cut out."));
  endFields();
}

}  // namespace sonoskin::ui
