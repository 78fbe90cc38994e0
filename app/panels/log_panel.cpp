#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>

#include "app/panels/panels.h"
#include "app/texts/texts.h"
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
  if (log.entries.empty()) ImGui::TextDisabled("%s", tr("Nothing was said yet"));
  for (const MessageLog::Entry& entry : log.entries)
    if (log.shows(entry)) drawEntry(entry);
  if (atEnd) ImGui::SetScrollHereY(1);  // follows what comes, until the person looks back
  ImGui::EndChild();
}

// Which kinds are shown, and how many there are of each.
void drawLevels(MessageLog& log) {
  const std::array<const char*, 3> titles{tr("Notes"), tr("Warnings"), tr("Errors")};
  for (std::size_t kind = 0; kind < titles.size(); ++kind) {
    if (kind > 0) ImGui::SameLine(0, 16 * unit());
    const std::string text =
        fmt::format("{} ({})###{}", titles[kind], log.count(MessageLog::Kind(kind)), kind);
    ImGui::Checkbox(text.c_str(), &log.levels[kind]);
    noteWidget(fmt::format("messages.level{}", kind));
  }
}

bool button(const char* text, const char* name) {
  const bool pressed = ImGui::Button(text, {90 * unit(), 0});
  noteWidget(name);
  return pressed;
}

void drawButtons(Workspace& workspace) {
  MessageLog& log = workspace.toasts.log;
  if (button(tr("Copy"), "messages.copy")) ImGui::SetClipboardText(log.text().c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr("What is shown, without names of files"));
  ImGui::SameLine();
  if (button(tr("Save..."), "messages.save"))
    workspace.files.ask(FilePurpose::saveMessages, workspace.settings.folder, "messages.txt");
  ImGui::SameLine();
  if (button(tr("Clear"), "messages.clear")) log.clear();
  ImGui::SameLine();
  if (button(tr("Close"), "messages.close")) log.shown = false;
}

}  // namespace

void drawLog(Workspace& workspace) {
  MessageLog& log = workspace.toasts.log;
  if (!log.shown) return;
  const ImVec2 corner = ImGui::GetMainViewport()->Size;
  ImGui::SetNextWindowPos({corner.x - 16 * unit(), corner.y - 40 * unit()}, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSize({600 * unit(), 280 * unit()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * unit());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const bool drawn = ImGui::Begin((std::string(tr("Messages")) + "###log").c_str(), &log.shown,
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
  if (drawn) {
    drawLevels(log);
    drawEntries(log);
    drawButtons(workspace);
  }
  ImGui::End();
}

}  // namespace sonoskin::ui
