#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/dialog_window.h"
#include "app/panels/licences.h"
#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "core/base/version.h"

namespace sonoskin::ui {
namespace {

void drawProgram(const Workspace& workspace) {
  ImGui::PushFont(headingFont());
  ImGui::Text("Sonoskin %s", kVersion);
  ImGui::PopFont();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(
      tr("Turns a noisy three-dimensional ultrasound scan into a smooth surface of the face, and "
         "the surface into a picture."));
  ImGui::PushStyleColor(ImGuiCol_Text, colours().warning);
  ImGui::TextUnformatted(
      tr("For research and keepsakes. Not for diagnosis: what is seen here may have been "
         "smoothed away or filled in."));
  ImGui::PopStyleColor();
  ImGui::TextDisabled("OpenGL: %s", workspace.glInfo.c_str());
  ImGui::PopTextWrapPos();
}

// The names, of which one is chosen by the mouse or with Up and Down.
void drawNames(std::size_t& chosen) {
  if (ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const int step = int(pressed(ImGuiKey_DownArrow)) - int(pressed(ImGuiKey_UpArrow));
    chosen = std::size_t(std::clamp(int(chosen) + step, 0, int(licences().size()) - 1));
  }
  for (std::size_t n = 0; n < licences().size(); ++n) {
    const Licence& part = licences()[n];
    if (ImGui::Selectable(fmt::format("{}##{}", part.name, n).c_str(), n == chosen)) chosen = n;
    noteWidget(std::string("about.") + part.name);
    if (n == chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
  }
}

void drawLicences(std::size_t& chosen) {
  ImGui::TextDisabled("%s", tr("What it is made of, and under which licences"));
  ImGui::BeginChild("names", {170 * unit(), 0});
  drawNames(chosen);
  ImGui::EndChild();
  ImGui::SameLine();
  const Licence& part = licences()[chosen];
  ImGui::BeginChild(part.name, {0, 0}, true);  // each keeps where it was scrolled to
  ImGui::Text("%s: %s", part.name, part.licence);
  ImGui::PushFont(smallFont());
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(part.text);
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::EndChild();
}

}  // namespace

void drawAbout(Workspace& workspace) {
  if (!workspace.aboutShown) return;
  if (beginDialog({tr("About Sonoskin"), "###about", {800, 580}}, workspace.aboutShown)) {
    drawProgram(workspace);
    ImGui::Spacing();
    drawLicences(workspace.help.licence);
  }
  ImGui::End();
}

}  // namespace sonoskin::ui
