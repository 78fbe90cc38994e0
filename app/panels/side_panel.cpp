#include <imgui.h>

#include "app/panels/panels.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

void drawStep(Workspace& workspace) {
  switch (workspace.step) {
    case Step::volume:
      return drawVolumePanel(workspace);
    case Step::region:
      return drawRegionPanel(workspace);
    case Step::classify:
      return drawClassificationPanel(workspace);
    case Step::surface:
      return drawReconstructionPanel(workspace);
    case Step::skin:
      return drawSkinPanel(workspace);
    case Step::output:
      return drawExportPanel(workspace);
  }
}

// What the views mark for an open heading of the skin's parameters goes with them.
void forgetMarks(Workspace& workspace) {
  if (workspace.step != Step::skin) workspace.view.skin.reach = workspace.view.skin.places = false;
}

// Each step has a window of its own: it keeps where it was scrolled to. The bar's room is reserved, so that rows do not
// become narrower where one comes.
void drawScrolled(Workspace& workspace, float height) {
  section(stepTitle(workspace.step));
  ImGui::BeginChild(stepName(workspace.step), {0, height - ImGui::GetCursorPosY()}, false,
                    ImGuiWindowFlags_AlwaysVerticalScrollbar | ImGuiWindowFlags_NavFlattened);
  drawStep(workspace);
  ImGui::EndChild();
}

}  // namespace

float sidePanelWidth() { return 376 * unit(); }

ToastPlace drawSidePanel(Workspace& workspace, ImVec2 size) {
  ImGui::BeginChild("side", size, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                        ImGuiWindowFlags_NoScrollWithMouse);
  const ImGuiStyle& style = ImGui::GetStyle();
  drawStepList(workspace);
  forgetMarks(workspace);
  const float bottom = size.y - style.WindowPadding.y - workHeight();
  drawScrolled(workspace, bottom - style.ItemSpacing.y);
  ImGui::SetCursorPosY(bottom);
  const ImVec2 work = ImGui::GetCursorScreenPos();
  drawWork(workspace);
  const ToastPlace place{work.x, work.y - style.ItemSpacing.y, size.x - 2 * style.WindowPadding.x};
  ImGui::EndChild();
  return place;
}

}  // namespace sonoskin::ui
