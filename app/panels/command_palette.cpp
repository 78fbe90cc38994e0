#include "app/panels/command_palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/palette_entries.h"

namespace sonoskin::ui {
namespace {

constexpr const char* kPopup = "###palette";
constexpr float kWidth = 700, kMostRows = 12;

// Up and Down belong to the list while the field has the keys.
int countSteps(ImGuiInputTextCallbackData* data) {
  *static_cast<int*>(data->UserData) += data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
  return 0;
}

// The field; true when the chosen command is wanted. `moved` by the arrows, and to the first by other words.
bool drawField(HelpState& help, std::size_t count, bool& moved) {
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  int steps = 0;
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint(
      "##words", tr("Find a command or a parameter"), &help.words,
      ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_EnterReturnsTrue, countSteps, &steps);
  noteWidget("palette.words");
  const bool edited = ImGui::IsItemEdited();
  if (edited) help.chosen = 0;
  if (steps != 0 && count > 0) {
    const int to = std::clamp(int(help.chosen) + steps, 0, int(count) - 1);
    help.chosen = std::size_t(to);
  }
  moved = edited || steps != 0;
  return entered;
}

void drawRight(const char* text) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room, 0.0f));
  ImGui::TextDisabled("%s", text);
}

// A line of the list; true when it was clicked.
bool drawLine(const PaletteEntry& entry, bool chosen) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(entry.id.c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, entry.enabled ? colours().text : colours().faintText);
  ImGui::PushStyleColor(ImGuiCol_Header, withAlpha(colours().accent, 0.3f));
  const bool clicked =
      ImGui::Selectable(entry.title.c_str(), chosen,
                        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_DontClosePopups);
  ImGui::PopStyleColor(2);
  ImGui::PopID();
  noteWidget("palette." + entry.id);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", entry.where.c_str());
  ImGui::TableNextColumn();
  drawRight(entry.key.c_str());
  return clicked;
}

// Of the longest that any command has, so that nothing moves as one types.
float keyWidth() {
  float width = 0;
  for (const Command& c : commands())
    width = std::max(width, ImGui::CalcTextSize(shortcutText(c.shortcut).c_str()).x);
  return width + 1;
}

// The list; the entry that was clicked, if any. `follow`: the chosen line comes into sight.
const PaletteEntry* drawList(const std::vector<PaletteEntry>& found, std::size_t chosen, bool follow) {
  if (found.empty()) {
    ImGui::TextDisabled("%s", tr("No command or parameter has these words"));
    return nullptr;
  }
  const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float rows = std::min(float(found.size()), kMostRows);
  if (!ImGui::BeginTable("found", 3, ImGuiTableFlags_ScrollY, {0, rows * line + 2 * unit()})) return nullptr;
  ImGui::TableSetupColumn("title", ImGuiTableColumnFlags_WidthStretch, 3);
  ImGui::TableSetupColumn("where", ImGuiTableColumnFlags_WidthStretch, 1.2f);
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, keyWidth());
  const PaletteEntry* clicked = nullptr;
  for (std::size_t n = 0; n < found.size(); ++n) {
    if (drawLine(found[n], n == chosen)) clicked = &found[n];
    if (n == chosen && follow) ImGui::SetScrollHereY();
  }
  ImGui::EndTable();
  return clicked;
}

// What is to be done, if anything.
std::function<void(Workspace&)> drawContents(Workspace& workspace) {
  HelpState& help = workspace.help;
  bool moved = false;
  std::vector<PaletteEntry> found = paletteEntries(help.words, workspace);
  const bool entered = drawField(help, found.size(), moved);
  if (moved) found = paletteEntries(help.words, workspace);
  const PaletteEntry* wanted = drawList(found, help.chosen, moved);
  if (entered && help.chosen < found.size()) wanted = &found[help.chosen];
  return wanted && wanted->enabled ? wanted->run : nullptr;
}

}  // namespace

void drawPalette(Workspace& workspace) {
  HelpState& help = workspace.help;
  if (!help.paletteShown) return;
  if (std::exchange(help.paletteOpens, false)) ImGui::OpenPopup(kPopup);
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  ImGui::SetNextWindowPos({viewport.GetCenter().x, viewport.WorkPos.y + 0.1f * viewport.WorkSize.y},
                          ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({kWidth * unit(), 0});
  if (!ImGui::BeginPopup(kPopup, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav)) {
    help.paletteShown = false;  // a click elsewhere has closed it
    return;
  }
  const std::function<void(Workspace&)> wanted = drawContents(workspace);
  const bool closed = wanted || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (closed) {
    help.paletteShown = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (wanted) wanted(workspace);
}

}  // namespace sonoskin::ui
