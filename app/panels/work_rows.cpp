// What goes on, and how to begin and end it: at the bottom of the side panel, whatever step is open.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

constexpr float kButtonHeight = 34;  // as mainButton has it

// The button beside the bar: ends what goes on, or takes it up again.
void drawCancel(Session& session, bool busy, bool stopped, float width) {
  const DisabledIf disabled(!busy && !stopped);
  if (ImGui::Button(tr(stopped ? "Continue" : "Cancel"), {width, 0}))
    stopped ? session.resume() : session.cancel();
  noteWidget(stopped ? "surface.resume" : "surface.cancel");
}

std::string progressText(const Activity& activity, DocumentState state) {
  if (!activity.busy) return tr(stateText(state));
  return fmt::format("{}  {:.0f} %", sentence(trSentence(activity.what)), 100 * activity.fraction);
}

// One line that is always there, so that nothing moves when work begins and ends.
void drawProgress(Workspace& workspace, const Activity& activity) {
  const float words = std::max(ImGui::CalcTextSize(tr("Cancel")).x, ImGui::CalcTextSize(tr("Continue")).x);
  const float cancel = std::max(78 * unit(), words + 2 * ImGui::GetStyle().FramePadding.x);
  const DocumentState state = workspace.session.state();
  const bool settled =
      state == DocumentState::current || state == DocumentState::empty || state == DocumentState::noSurface;
  ImGui::ProgressBar(
      static_cast<float>(activity.busy ? activity.fraction : 0),
      {ImGui::GetContentRegionAvail().x - cancel - ImGui::GetStyle().ItemSpacing.x, ImGui::GetFrameHeight()},
      "");
  noteWidget("surface.state");
  const ImVec2 at = ImGui::GetItemRectMin(), padding = ImGui::GetStyle().FramePadding;
  ImGui::GetWindowDrawList()->AddText({at.x + padding.x, at.y + padding.y},
                                      ImGui::GetColorU32(activity.busy ? colours().text
                                                         : settled     ? colours().faintText
                                                                       : colours().warning),
                                      progressText(activity, state).c_str());
  ImGui::SameLine();
  drawCancel(workspace.session, activity.busy, !activity.busy && state == DocumentState::stopped, cancel);
}

}  // namespace

float workHeight() {
  const ImGuiStyle& style = ImGui::GetStyle();
  return kButtonHeight * unit() + ImGui::GetFrameHeight() + 2 * style.ItemSpacing.y;
}

void drawWork(Workspace& workspace) {
  const Activity activity = workspace.session.activity();
  const Command& reconstruct = command("surface.reconstruct");
  if (mainButton(tr(reconstruct.title), isEnabled(reconstruct, workspace) && !activity.blocking))
    reconstruct.run(workspace);
  noteWidget(reconstruct.id);
  drawProgress(workspace, activity);
}

}  // namespace sonoskin::ui
