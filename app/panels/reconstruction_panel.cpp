#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

// The button beside the bar: ends what goes on, or takes it up again.
void drawCancel(Session& session, bool busy, bool stopped, float width) {
  const DisabledIf disabled(!busy && !stopped);
  if (ImGui::Button(stopped ? "Go on" : "Cancel", {width, 0})) stopped ? session.resume() : session.cancel();
  noteWidget(stopped ? "surface.resume" : "surface.cancel");
}

// One line that is always there, so that nothing below moves when work begins and ends.
void drawProgress(Workspace& workspace, const Activity& activity) {
  const float cancel = 72 * unit();
  const DocumentState state = workspace.session.state();
  const bool settled = state == DocumentState::current || state == DocumentState::empty;
  const std::string text = activity.busy
                               ? fmt::format("{}  {:.0f} %", sentence(activity.what), 100 * activity.fraction)
                               : stateText(state);
  ImGui::PushStyleColor(ImGuiCol_Text, activity.busy ? kText
                                       : settled     ? ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled)
                                                     : kWarning);
  ImGui::ProgressBar(
      static_cast<float>(activity.busy ? activity.fraction : 0),
      {ImGui::GetContentRegionAvail().x - cancel - ImGui::GetStyle().ItemSpacing.x, ImGui::GetFrameHeight()},
      text.c_str());
  ImGui::PopStyleColor();
  noteWidget("surface.state");
  ImGui::SameLine();
  drawCancel(workspace.session, activity.busy, state == DocumentState::stopped, cancel);
}

void drawMeshFacts(const Session& session) {
  const Results& results = session.results();
  if (results.points) fact("Points", grouped(results.points->size()));
  if (!results.mesh) return;
  fact("Triangles", grouped(results.mesh->triangles.size()));
  fact("Area", fmt::format("{} mm²", grouped(static_cast<std::size_t>(session.meshArea() + 0.5))));
  if (results.verdicts) {
    const auto kept = std::count_if(results.verdicts->begin(), results.verdicts->end(),
                                    [](const PartVerdict& v) { return v.kept; });
    fact("Parts", fmt::format("{}, {} shown (P)", results.verdicts->size(), kept));
  } else if (results.pieces && results.pieces->size() > 1) {
    fact("Pieces", fmt::format("{}, one is shown", results.pieces->size()));
  }
}

// What speaks against this being skin; it stays as long as it holds.
void drawWarnings(const Session& session) {
  for (const std::string& warning : session.warnings()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted((sentence(warning) + ".").c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    noteWidget("surface.warning");
  }
}

// The one parameter of the fit that a person turns; the others are under "Advanced".
constexpr std::array<std::string_view, 1> kFirst{"smoothness"};

// The rows of a group under a small heading.
template <class Options>
FieldsEdit drawBlock(const char* title, std::string_view group, Options& options, const Rows& rows) {
  FieldsEdit edit;
  ImGui::TextDisabled("%s", title);
  if (!beginFields(title)) return edit;
  edit = editFields(group, options, rows);
  endFields();
  return edit;
}

FieldsEdit drawAdvanced(Parameters& p) {
  FieldsEdit edit;
  if (!foldout("Advanced##surface",
               "How the surface is fitted, made of triangles, and prepared for a printer."))
    return edit;
  edit |= drawBlock("Fit", "reconstruction", p.reconstruction, {kFirst, true, useOf(p, "reconstruction")});
  if (p.reconstruction.method == ReconstructionMethod::global)
    edit |= drawBlock("One function through all points", "global", p.global, {{}, false, useOf(p, "global")});
  edit |= drawBlock("Mesh", "mesh", p.mesh, {{}, false, useOf(p, "mesh")});
  edit |= drawBlock("Print", "print", p.print, {{}, false, useOf(p, "print")});
  ImGui::Dummy({0, 4 * unit()});
  return edit;
}

void drawParameters(Workspace& workspace) {
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  if (beginFields("smoothness")) {
    edit = editFields("reconstruction", parameters.reconstruction, {kFirst});
    endFields();
  }
  edit |= drawAdvanced(parameters);
  applyEdit(workspace, parameters, edit);
}

}  // namespace

void drawReconstructionPanel(Workspace& workspace) {
  section("Surface");
  drawParameters(workspace);
  const Activity activity = workspace.session.activity();
  const Command& reconstruct = command("surface.reconstruct");
  if (mainButton(reconstruct.title, isEnabled(reconstruct, workspace) && !activity.blocking)) {
    reconstruct.run(workspace);
  }
  noteWidget(reconstruct.id);
  drawProgress(workspace, activity);
  drawWarnings(workspace.session);
  drawMeshFacts(workspace.session);
  if (workspace.session.results().mesh) {
    for (const char* id : {"file.saveMesh", "file.savePrint"}) {
      const Command& save = command(id);
      if (ImGui::Button(save.title, {-1, 0})) save.run(workspace);
      noteWidget(save.id);
    }
  }
}

}  // namespace sonoskin::ui
