#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/panels/question_box.h"
#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

// What the numbers would take that were told.
double bytesOf(const RawOptions& o) {
  return double(o.dims[0]) * o.dims[1] * o.dims[2] * double(numberTypeBytes(o.type)) * o.timeSteps;
}

// Whether the numbers that were told fill the file, in a line for people.
bool drawSize(const Workspace::RawQuestion& asked) {
  const double told = bytesOf(asked.options), there = double(asked.bytes);
  const double wanted = told + std::max(asked.options.header, 0);
  const bool fits = told > 0 && (asked.options.header < 0 ? told <= there : wanted == there);
  const std::string text = fits ? trf("The file has {} bytes, as many as that.", grouped(asked.bytes))
                                : trf("The file has {} bytes; that is {:.0f}.", grouped(asked.bytes), wanted);
  ImGui::TextColored(fits ? colours().text : colours().warning, "%s", text.c_str());
  return fits;
}

}  // namespace

void drawRawQuestion(Workspace& workspace) {
  if (!workspace.rawQuestion) return;
  const std::string title = trId("What the file holds");
  if (!askQuestion(title.c_str())) return;
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({440 * unit(), 0});
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
    return;
  Workspace::RawQuestion& asked = *workspace.rawQuestion;
  ImGui::TextWrapped("%s", trf("{} has no header; what is in it?", asked.file.filename().string()).c_str());
  ImGui::Spacing();
  Parameters shown;
  shown.raw = asked.options;
  if (beginFields("raw")) {
    editFields("raw", asked.options, {.text = useOf(shown, "raw")});
    endFields();
  }
  const bool fits = drawSize(asked);
  ImGui::Spacing();
  const ImVec2 size{112 * unit(), 0};
  const bool stays = ImGui::Button(tr("Cancel"), size);
  noteWidget("raw.cancel");
  ImGui::SameLine();
  ImGui::BeginDisabled(!fits);
  const bool opens = ImGui::Button(tr("Open"), size);
  ImGui::EndDisabled();
  noteWidget("raw.open");
  if (stays || opens) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (opens) workspace.openRaw();
  if (stays) workspace.rawQuestion.reset();
}

}  // namespace sonoskin::ui
