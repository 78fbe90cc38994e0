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

// Another spacing makes another surface of it.
void applySpacing(Workspace& workspace, const glm::dvec3& spacing) {
  workspace.confirmLoss(tr("Setting the spacing"), [&workspace, spacing] {
    Parameters parameters = workspace.session.parameters();
    parameters.scan.spacing = {spacing.x, spacing.y, spacing.z};
    workspace.session.edit(parameters);
    workspace.session.commitEdit();
  });
}

// For a file without spacing: says so and asks, since every millimetre in the window depends on it.
void askSpacing(Workspace& workspace, bool known) {
  ImGui::PushTextWrapPos();
  if (!known)
    ImGui::TextColored(
        colours().warning, "%s",
        tr("The file gives no voxel spacing; 1 mm stands for it, so lengths and areas are not real."));
  ImGui::PopTextWrapPos();
  glm::dvec3& spacing = workspace.typedSpacing;
  const double least = 0.001, most = 100;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 70 * unit());
  ImGui::DragScalarN("##spacing", ImGuiDataType_Double, &spacing.x, 3, 0.005f, &least, &most, "%.3f mm",
                     ImGuiSliderFlags_AlwaysClamp);
  noteWidget("volume.spacing");
  ImGui::SameLine();
  if (ImGui::Button(tr("Apply"), {-1, 0})) applySpacing(workspace, spacing);
  noteWidget("volume.applySpacing");
}

// The slider shows the step that was asked for; the picture follows.
void drawStepSlider(Workspace& workspace, int steps) {
  const bool plays = workspace.play.on;
  if (ImGui::Button(tr(plays ? "Stop" : "Play"), {58 * unit(), 0})) play(workspace, !plays);
  noteWidget("volume.play");
  ImGui::SameLine();
  int time = workspace.session.parameters().scan.time;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##time", &time, 1, steps, trf("step %d of {}", steps).c_str(),
                       ImGuiSliderFlags_AlwaysClamp))
    showStep(workspace, time);
  if (ImGui::IsItemDeactivatedAfterEdit()) workspace.session.commitEdit();
  noteWidget("volume.time");
}

// Which steps are played and saved as a sequence.
void drawStepRange(TimePlay& range, int steps) {
  int first = std::clamp(range.first, 1, steps), last = range.last > 0 ? std::min(range.last, steps) : steps;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", tr("Range"));
  ImGui::SameLine(66 * unit());
  ImGui::SetNextItemWidth(-1);
  if (ImGui::DragIntRange2("##range", &first, &last, 0.1f, 1, steps, tr("from %d"), tr("to %d"),
                           ImGuiSliderFlags_AlwaysClamp)) {
    range.first = first;
    range.last = last;
  }
  noteWidget("volume.range");
}

std::string range(const Scan& scan) {
  return trf("{} {:g} to {:g}", scan.originalType, scan.originalMin, scan.originalMax);
}

// What has no effect for the parameters' sake, or the file's.
std::function<RowText(std::string_view)> scanUse(const Session& session, const Parameters& parameters) {
  return [use = useOf(parameters, "scan"), given = session.givesSpacing()](std::string_view field) {
    if (field == "spacing" && given) return RowText{.unused = tr("The file gives the spacing")};
    return use(field);
  };
}

void drawParameters(Workspace& workspace) {
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit = groupRows(tr("How it was recorded"), "scan", parameters.scan,
                              {{}, false, scanUse(workspace.session, parameters)});
  // What another scan would be simulated with is nothing of one from a file.
  const bool simulated = !workspace.session.hasScan() || workspace.session.isPhantom();
  if (simulated)
    edit |= groupRows(tr("Simulated scan"), "phantom", parameters.phantom,
                      {{}, false, useOf(parameters, "phantom")});
  applyEdit(workspace, parameters, edit);
  if (!simulated) return;
  if (ImGui::Button(tr("Simulate again"), {-1, 0})) command("file.phantom").run(workspace);
  noteWidget("phantom.simulate");
}

// The lines are there before there is a scan, so that nothing below them moves when it comes.
void drawFacts(const Session& session) {
  if (!session.hasScan()) {
    fact(tr("Name"), tr("Nothing is open yet"));
    for (const char* label : {"Voxels", "Spacing", "Size", "Values"}) fact(tr(label), "–");
    return;
  }
  const Scan& scan = session.scan();
  const Geometry& g = scan.volume->geometry;
  const glm::dvec3 size = g.spacing * glm::dvec3(g.dims);
  fact(tr("Name"), session.isPhantom() ? tr("Phantom") : session.name());
  fact(tr("Voxels"), fmt::format("{} × {} × {}", g.dims.x, g.dims.y, g.dims.z));
  const std::string spacing = fmt::format("{} × {} × {} mm", millimetres(g.spacing.x),
                                          millimetres(g.spacing.y), millimetres(g.spacing.z));
  fact(tr("Spacing"), scan.spacingKnown ? spacing : tr("unknown"), !scan.spacingKnown);
  fact(tr("Size"), fmt::format("{:.0f} × {:.0f} × {:.0f} mm", size.x, size.y, size.z), !scan.spacingKnown);
  fact(tr("Values"), range(scan));
}

}  // namespace

void drawVolumePanel(Workspace& workspace) {
  const Session& session = workspace.session;
  drawFacts(session);
  if (session.hasScan()) {
    const Scan& scan = session.scan();
    if (scan.timeSteps > 1) {
      drawStepSlider(workspace, scan.timeSteps);
      drawStepRange(workspace.play, scan.timeSteps);
    }
    if (!session.givesSpacing()) askSpacing(workspace, scan.spacingKnown);
  }
  drawParameters(workspace);
}

}  // namespace sonoskin::ui
