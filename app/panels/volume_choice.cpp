#include <fmt/format.h>
#include <imgui.h>

#include <utility>

#include "app/panels/panels.h"
#include "app/panels/question_box.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

// The number of the volume that was pressed, from 1; 0: none.
int drawList(const std::vector<VolumeEntry>& volumes) {
  int chosen = 0;
  const float rows = float(std::min<std::size_t>(volumes.size(), 12));
  ImGui::BeginChild("volumes", {360 * unit(), (rows + 0.5f) * ImGui::GetFrameHeightWithSpacing()});
  for (std::size_t n = 0; n < volumes.size(); ++n) {
    const std::string label = fmt::format("{}   {}", n + 1, entryText(volumes[n]));
    if (ImGui::Selectable(label.c_str())) chosen = int(n) + 1;
    noteWidget(fmt::format("choice.{}", n + 1));
  }
  ImGui::EndChild();
  return chosen;
}

}  // namespace

void drawVolumeChoice(Workspace& workspace) {
  if (!workspace.choice) return;
  const std::string title = trId("Choose a volume");
  if (!askQuestion(title.c_str())) return;
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr,
                              ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
    return;
  ImGui::TextUnformatted(
      trf("There are {} volumes; which one is to be opened?", workspace.choice->volumes.size()).c_str());
  ImGui::Spacing();
  const int chosen = drawList(workspace.choice->volumes);
  const bool stays = ImGui::Button(tr("Cancel"), {112 * unit(), 0});
  noteWidget("choice.cancel");
  if (stays || chosen > 0) {
    const VolumeChoice choice = *std::exchange(workspace.choice, std::nullopt);
    ImGui::CloseCurrentPopup();
    if (chosen > 0) workspace.session.openVolume(choice, chosen);
  }
  ImGui::EndPopup();
}

}  // namespace sonoskin::ui
