#include "app/panels/dialog_window.h"

#include <algorithm>
#include <string>

#include "app/widgets/theme.h"

namespace sonoskin::ui {

bool beginDialog(const DialogWindow& dialog, bool& shown) {
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  const float edge = 16 * unit();
  const ImVec2 size{std::min(dialog.size.x * unit(), viewport.WorkSize.x - 2 * edge),
                    std::min(dialog.size.y * unit(), viewport.WorkSize.y - 2 * edge)};
  ImGui::SetNextWindowPos(viewport.GetWorkCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * unit());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const bool drawn = ImGui::Begin((std::string(dialog.title) + dialog.id).c_str(), &shown,
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
  return drawn;
}

}  // namespace sonoskin::ui
