#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/panels/panels.h"
#include "app/panels/state_mark.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/stages.h"

namespace sonoskin::ui {
namespace {

float rowHeight() { return 27 * unit(); }
float cancelWidth() { return 24 * unit(); }

// Where the parts of a row are, on the screen.
struct RowPlace {
  ImVec2 min, max;
  float y;  // of its text
};

// "stale  88,412 triangles"; while it works, how far that has come.
std::string saidOf(const Stage& stage, const std::string& timeLeft) {
  if (stage.state == StageState::working)
    return fmt::format("{:.0f} %{}{}", 100 * stage.fraction, timeLeft.empty() ? "" : ", ", timeLeft);
  const bool calm = stage.state == StageState::ready || stage.state == StageState::nothing;
  if ((calm || stage.step == Step::output) && !stage.number.empty()) return stage.number;
  return fmt::format("{}{}{}", stage.number, stage.number.empty() ? "" : ", ", stageWord(stage.state));
}

std::string secondsText(double seconds) {
  return seconds <= 0   ? ""
         : seconds < 10 ? fmt::format("{:.2f} s", seconds)
                        : fmt::format("{:.0f} s", seconds);
}

void textFromRight(float right, float y, const ImVec4& colour, const std::string& text) {
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetWindowDrawList()->AddText({right - width, y}, ImGui::GetColorU32(colour), text.c_str());
}

void drawGround(const Stage& stage, const RowPlace& row, bool chosen) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  if (chosen) {
    list.AddRectFilled(row.min, row.max, ImGui::GetColorU32(withAlpha(colours().accent, 0.2f)), rounding);
    list.AddRectFilled(row.min, {row.min.x + 3 * unit(), row.max.y}, ImGui::GetColorU32(colours().accent),
                       rounding);
  } else if (ImGui::IsItemHovered()) {
    list.AddRectFilled(row.min, row.max, ImGui::GetColorU32(ImGuiCol_HeaderHovered), rounding);
  }
  if (stage.state != StageState::working) return;
  const float right = row.min.x + float(stage.fraction) * (row.max.x - row.min.x);
  list.AddRectFilled({row.min.x, row.max.y - 3 * unit()}, {right, row.max.y},
                     ImGui::GetColorU32(colours().accent));
}

void explain(const Stage& stage) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(stepHelp(stage.step));
  ImGui::TextDisabled("%s%s%s", stageWord(stage.state), stage.number.empty() ? "" : ", ",
                      stage.number.c_str());
  ImGui::TextDisabled("%s%d", tr("Ctrl+"), int(stage.step) + 1);
  ImGui::EndTooltip();
}

// The button takes the place of the time, while the step works.
void drawEnd(Session& session, const Stage& stage, const RowPlace& row) {
  if (stage.state != StageState::working)
    return textFromRight(row.max.x - 8 * unit(), row.y, colours().faintText, secondsText(stage.seconds));
  ImGui::SameLine(0, 0);
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  if (ImGui::Button("×##cancel", {cancelWidth(), rowHeight()})) session.cancel();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  noteWidget("step.cancel");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr("Cancel"));
}

void drawRow(Workspace& workspace, const Stage& stage, const std::string& timeLeft) {
  const bool working = stage.state == StageState::working;
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(stepName(stage.step));
  if (ImGui::InvisibleButton("open", {width - (working ? cancelWidth() : 0), rowHeight()}))
    workspace.step = stage.step;
  noteWidget(std::string("step.") + stepName(stage.step));
  RowPlace row{ImGui::GetItemRectMin(), {ImGui::GetItemRectMin().x + width, ImGui::GetItemRectMax().y}, 0};
  row.y = std::floor(0.5f * (row.min.y + row.max.y - ImGui::GetFontSize()));
  drawGround(stage, row, workspace.step == stage.step);
  explain(stage);
  drawStateMark(stage.state, {row.min.x + 17 * unit(), 0.5f * (row.min.y + row.max.y)});
  ImGui::GetWindowDrawList()->AddText({row.min.x + 34 * unit(), row.y}, ImGui::GetColorU32(colours().text),
                                      stepTitle(stage.step));
  textFromRight(row.max.x - 62 * unit(), row.y,
                stage.state == StageState::ready ? colours().faintText : colourOf(stage.state),
                saidOf(stage, timeLeft));
  drawEnd(workspace.session, stage, row);
  ImGui::PopID();
}

}  // namespace

void drawStepList(Workspace& workspace) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 1 * unit()));
  const std::string timeLeft =
      timeLeftText(workspace.timeLeft.of(workspace.session.activity(), ImGui::GetTime()));
  for (const Stage& stage : stagesOf(workspace)) drawRow(workspace, stage, timeLeft);
  ImGui::PopStyleVar();
}

}  // namespace sonoskin::ui
