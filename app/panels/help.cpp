#include <imgui.h>

#include <array>

#include "app/panels/panels.h"
#include "app/widgets/theme.h"
#include "app/workspace/commands.h"
#include "core/base/version.h"

namespace sonoskin::ui {
namespace {

struct MouseLine {
  const char *where, *what, *effect;
};
constexpr std::array<MouseLine, 27> kMouse{{
    {"Slices", "Left button", "move the cross-hair"},
    {"", "Wheel", "next slice"},
    {"", "Ctrl+wheel", "zoom"},
    {"", "Middle or Shift+left", "pan"},
    {"", "Right", "window (sideways), level (up and down)"},
    {"", "Left on a side of the crop box", "move it"},
    {"Eraser", "Left", "erase a ball"},
    {"", "Ctrl+left", "bring back"},
    {"Outline", "Left", "cut out what is seen within it"},
    {"", "Ctrl+left", "bring it back"},
    {"", "Shift+left", "keep nothing but what is seen within it"},
    {"Measure", "Click, or drag", "set a mark, or move one"},
    {"", "Double click", "close an area"},
    {"3D", "Left", "rotate"},
    {"", "Middle or Shift+left", "pan"},
    {"", "Right or wheel", "zoom"},
    {"", "Click on the cube", "look from that side"},
    {"Parts", "Click", "take a part away, or bring it back"},
    {"", "Shift+click", "leave that part alone"},
    {"", "Ctrl+left", "draw a line that splits a part"},
    {"Skin", "Left on the lamp", "move the light; beyond the rim: behind"},
    {"", "Wheel on the lamp", "its distance, if it is near or inside"},
    {"", "Left on the dividing line", "move it, where two pictures are compared"},
    {"Any view", "Double click", "alone and back"},
    {"Sliders", "Double click or right", "default"},
    {"", "Click on the number", "type it"},
    {"Window", "Drop a file", "open it"},
}};

bool beginDialog(const char* title, bool* open) {
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * unit());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const bool drawn = ImGui::Begin(title, open,
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
  return drawn;
}

void keyRow(const char* where, const char* what, const char* effect) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", where);
  ImGui::TableNextColumn();
  ImGui::TextColored(colours().accent, "%s", what);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(effect);
}

}  // namespace

void drawKeys(Workspace& workspace) {
  if (!workspace.keysShown) return;
  if (beginDialog("Mouse and keys", &workspace.keysShown) && ImGui::BeginTable("keys", 3)) {
    ImGui::TableSetupColumn("where", ImGuiTableColumnFlags_WidthFixed, 70 * unit());
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 160 * unit());
    ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthFixed, 270 * unit());
    for (const MouseLine& line : kMouse) keyRow(line.where, line.what, line.effect);
    const char* where = "Keys";
    for (const Command& command : commands()) {
      if (command.shortcut.key == 0) continue;
      keyRow(where, shortcutText(command.shortcut).c_str(), command.title);
      where = "";
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

void drawAbout(Workspace& workspace) {
  if (!workspace.aboutShown) return;
  if (beginDialog("About Sonoskin", &workspace.aboutShown)) {
    ImGui::PushFont(headingFont());
    ImGui::Text("Sonoskin %s", kVersion);
    ImGui::PopFont();
    ImGui::PushTextWrapPos(430 * unit());
    ImGui::TextUnformatted(
        "Turns a noisy three-dimensional ultrasound scan into a smooth surface of the face, and "
        "the surface into a picture.");
    ImGui::Spacing();
    ImGui::TextColored(colours().warning,
                       "For research and keepsakes. Not for diagnosis: what is seen here may have been "
                       "smoothed away or filled in.");
    ImGui::Spacing();
    ImGui::TextDisabled(
        "MIT licence. Built with Dear ImGui, GLFW, ITK, Eigen, assimp and glm; set in Inter and "
        "DejaVu Sans.");
    ImGui::TextDisabled("OpenGL: %s", workspace.glInfo.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (ImGui::Button("Close", {90 * unit(), 0})) workspace.aboutShown = false;
  }
  ImGui::End();
}

}  // namespace sonoskin::ui
