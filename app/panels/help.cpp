#include <imgui.h>
#include <imgui_stdlib.h>

#include <span>
#include <string>
#include <vector>

#include "app/panels/dialog_window.h"
#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"
#include "app/workspace/palette_entries.h"
#include "app/workspace/word_match.h"

namespace sonoskin::ui {
namespace {

// What a hand does somewhere, and what that does.
//   id  for tests, the same in all languages
struct HelpLine {
  std::string where, what, effect, id = {};
};

std::vector<HelpLine> mouseLines() {
  std::vector<HelpLine> lines{
      {"Slices", "Left button", "move the cross-hair"},
      {"Slices", "Wheel", "next slice"},
      {"Slices", "Ctrl+wheel", "zoom"},
      {"Slices", "Middle or Shift+left", "pan"},
      {"Slices", "Right", "window (sideways), level (up and down)"},
      {"Slices", "Left on a side of the crop box", "move it"},
      {"Eraser", "Left", "erase a ball"},
      {"Eraser", "Ctrl+left", "bring back"},
      {"Outline", "Left", "cut out what is seen within it"},
      {"Outline", "Ctrl+left", "bring it back"},
      {"Outline", "Shift+left", "keep nothing but what is seen within it"},
      {"Measure", "Click, or drag", "set a mark, or move one"},
      {"Measure", "Double click", "close an area"},
      {"3D", "Left", "rotate"},
      {"3D", "Middle or Shift+left", "pan"},
      {"3D", "Right or wheel", "zoom"},
      {"3D", "Click on the cube", "look from that side"},
      {"Parts", "Click", "take a part away, or bring it back"},
      {"Parts", "Shift+click", "leave that part alone"},
      {"Parts", "Ctrl+left", "draw a line that splits a part"},
      {"Skin", "Left on the lamp", "move the light; beyond the rim: behind"},
      {"Skin", "Wheel on the lamp", "its distance, if it is near or inside"},
      {"Skin", "Left on the dividing line", "move it, where two pictures are compared"},
      {"Any view", "Double click", "alone and back"},
      {"Sliders", "Double click or right", "default"},
      {"Sliders", "Click on the number", "type it"},
      {"Window", "Drop a file", "open it"},
      {"Window", "F10 or Alt", "the menus: arrows, Enter, Escape"},
      {"Window", "Tab", "the side panel: arrows, Enter or space; Escape"},
  };
  for (HelpLine& line : lines)
    line = {tr(line.where.c_str()), tr(line.what.c_str()), tr(line.effect.c_str()),
            line.what + "." + line.effect};
  return lines;
}

std::vector<HelpLine> keyLines() {
  std::vector<HelpLine> lines;
  for (const Command& command : commands()) {
    if (command.shortcut.key == 0) continue;
    lines.push_back({tr(kMenuTitles[std::size_t(command.menu)]), shortcutText(command.shortcut),
                     commandTitle(command), command.id});
  }
  return lines;
}

void keepFitting(std::vector<HelpLine>& lines, const std::string& words) {
  std::erase_if(lines, [&](const HelpLine& line) {
    return !misfit(words, line.where + " " + line.what + " " + line.effect);
  });
}

float placeWidth(std::span<const HelpLine> lines) {
  float width = 0;
  for (const HelpLine& line : lines) width = std::max(width, ImGui::CalcTextSize(line.where.c_str()).x);
  return width + 1;
}

// Of the middle column, without scale.
float keyWidth(std::span<const HelpLine> lines) {
  float width = 0;
  for (const HelpLine& line : lines) width = std::max(width, ImGui::CalcTextSize(line.what.c_str()).x);
  return width / unit() + 1;
}

// Lines in a table; a place is named where it begins.
//   what  how wide the middle column is, without scale
void drawLines(const char* id, std::span<const HelpLine> lines, float what) {
  ImGui::TableNextColumn();
  if (!ImGui::BeginTable(id, 3)) return;
  ImGui::TableSetupColumn("where", ImGuiTableColumnFlags_WidthFixed, placeWidth(lines));
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, what * unit());
  ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthStretch);
  const std::string* where = nullptr;
  for (const HelpLine& line : lines) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (!where || line.where != *where) ImGui::TextDisabled("%s", line.where.c_str());
    where = &line.where;
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colours().accent);
    ImGui::TextWrapped("%s", line.what.c_str());
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", line.effect.c_str());
    noteWidget("help." + line.id);
  }
  ImGui::EndTable();
}

// The mouse beside the keys, in two columns of like length.
void drawAll(const std::string& words) {
  if (!ImGui::BeginTable("all", 3)) return;
  ImGui::TableSetupColumn("mouse", ImGuiTableColumnFlags_WidthStretch, 1.45f);
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, 1);
  ImGui::TableSetupColumn("more keys", ImGuiTableColumnFlags_WidthStretch, 1);
  std::vector<HelpLine> mouse = mouseLines(), keys = keyLines();
  keepFitting(mouse, words);
  keepFitting(keys, words);
  drawLines("mouse", mouse, 180);
  const std::span all(keys);
  const std::size_t half = (all.size() + 1) / 2;
  const float widest = keyWidth(all);
  drawLines("keys", all.first(half), widest);
  drawLines("more keys", all.subspan(half), widest);
  ImGui::EndTable();
}

}  // namespace

void drawKeys(Workspace& workspace) {
  if (!workspace.keysShown) return;
  if (beginDialog({tr("Mouse and keys"), "###keys", {1240, 880}}, workspace.keysShown)) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##words", tr("Search"), &workspace.help.keyWords);
    noteWidget("help.words");
    ImGui::BeginChild("lines");
    drawAll(workspace.help.keyWords);
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace sonoskin::ui
