#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "core/pipeline/face_use.h"

namespace sonoskin::ui {
namespace {

// A count, or that there is none: the line stays.
std::string countText(std::size_t count) { return count > 0 ? grouped(count) : "–"; }

std::string partsText(const Results& results) {
  if (results.mesh && results.verdicts) {
    const auto kept = std::count_if(results.verdicts->begin(), results.verdicts->end(),
                                    [](const PartVerdict& v) { return v.kept; });
    return trf("{}, {} shown (P)", results.verdicts->size(), kept);
  }
  if (results.mesh && results.pieces && results.pieces->size() > 1)
    return trf("{}, one is shown", results.pieces->size());
  return "–";
}

std::string areaText(const Session& session) {
  if (!session.results().mesh) return "–";
  return fmt::format("{} mm²", grouped(static_cast<std::size_t>(session.meshArea() + 0.5)));
}

// What was measured across the surface, and how far the points were moved onto it.
std::string edgeText(const Results& results) {
  const EdgeProfile& edge = results.edge;
  if (!results.points || edge.width <= 0) return "–";
  return trf("grey {:.2f} to {:.2f} in {:.1f} mm, points moved {:.2f} mm", edge.dark, edge.bright, edge.width,
             edge.shift + edge.depth);
}

void drawFacts(const Session& session) {
  const Results& results = session.results();
  fact(tr("Points"), countText(results.points ? results.points->size() : 0));
  fact(tr("Triangles"), countText(results.mesh ? results.mesh->triangles.size() : 0));
  fact(tr("Area"), areaText(session));
  fact(tr("Parts"), partsText(results));
}

// What speaks against this being skin; it stays as long as it holds.
void drawWarnings(const Session& session) {
  for (const std::string& warning : session.warnings()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colours().warning);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted((sentence(trSentence(warning)) + ".").c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    noteWidget("surface.warning");
  }
}

// The one parameter of the fit that a person turns.
constexpr std::array<std::string_view, 1> kFirst{"smoothness"};

// What was found, in a sentence.
void drawFace(const Workspace& workspace) {
  const std::string text =
      faceText(workspace.session.results().face.get(), workspace.session.parameters().face);
  if (!text.empty()) sentenceText(sentence(trSentence(text)).c_str());
}

FieldsEdit drawGroups(Parameters& p) {
  FieldsEdit edit = groupRows(tr("Points"), "surface", p.surface, {{}, false, useOf(p, "surface")});
  edit |=
      groupRows(tr("Fit"), "reconstruction", p.reconstruction, {kFirst, true, useOf(p, "reconstruction")});
  edit |=
      groupRows(tr("One function through all points"), "global", p.global, {{}, false, useOf(p, "global")});
  edit |= groupRows(tr("Triangles"), "mesh", p.mesh, {{}, false, useOf(p, "mesh")});
  edit |= groupRows(tr("Face"), "face", p.face, {{}, false, useOf(p, "face")});
  return edit;
}

}  // namespace

void drawReconstructionPanel(Workspace& workspace) {
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  if (beginFields("smoothness")) {
    edit = editFields("reconstruction", parameters.reconstruction, {kFirst});
    endFields();
  }
  drawFacts(workspace.session);
  edit |= drawGroups(parameters);
  applyEdit(workspace, parameters, edit);
  fact(tr("Edge"), edgeText(workspace.session.results()));
  drawFace(workspace);
  drawWarnings(workspace.session);
}

}  // namespace sonoskin::ui
