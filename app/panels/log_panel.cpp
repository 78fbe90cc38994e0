#include <imgui.h>

#include <array>

#include "app/panels/panels.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

void drawEntry(const MessageLog::Entry& entry) {
  const std::array<ImVec4, 3> inks{colours().text, colours().warning, colours().failure};
  ImGui::TextDisabled("%s", entry.time.c_str());
  ImGui::SameLine(70 * unit());
  ImGui::PushStyleColor(ImGuiCol_Text, inks[std::size_t(entry.kind)]);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(entry.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void drawEntries(const MessageLog& log) {
  ImGui::BeginChild("entries", {0, -ImGui::GetFrameHeightWithSpacing()});
  const bool atEnd = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
  if (log.entries.empty()) ImGui::TextDisabled("Nothing was said yet");
  for (const MessageLog::Entry& entry : log.entries) drawEntry(entry);
  if (atEnd) ImGui::SetScrollHereY(1);  // follows what comes, until the person looks back
  ImGui::EndChild();
}

}  // namespace

void drawLog(Workspace& workspace) {
  MessageLog& log = workspace.toasts.log;
  if (!log.shown) return;
  const ImVec2 corner = ImGui::GetMainViewport()->Size;
  const ImVec2 size{560 * unit(), 230 * unit()};
  ImGui::SetNextWindowPos({corner.x - 16 * unit(), corner.y - 40 * unit()}, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * unit());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const bool drawn = ImGui::Begin("Messages", &log.shown,
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
  if (drawn) {
    drawEntries(log);
    if (ImGui::Button("Copy all", {90 * unit(), 0})) ImGui::SetClipboardText(log.text().c_str());
    noteWidget("messages.copy");
    ImGui::SameLine();
    if (ImGui::Button("Close", {90 * unit(), 0})) log.shown = false;
    noteWidget("messages.close");
  }
  ImGui::End();
}

}  // namespace sonoskin::ui
