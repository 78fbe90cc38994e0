#include "app/widgets/file_dialog.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cstdlib>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

namespace fs = std::filesystem;

std::string sizeText(std::uintmax_t bytes) {
  const double kilobytes = double(bytes) / 1024;
  return kilobytes < 1000 ? fmt::format("{:.0f} kB", kilobytes) : fmt::format("{:.1f} MB", kilobytes / 1024);
}

// The folders from the root down to the present one, each a button.
void drawPath(FileDialog& dialog) {
  fs::path clicked, upTo;
  for (const fs::path& part : dialog.folder) {
    upTo /= part;
    if (upTo != dialog.folder.root_path()) ImGui::SameLine(0, 2 * unit());
    ImGui::PushID(upTo.c_str());
    if (ImGui::SmallButton(part.c_str())) clicked = upTo;
    ImGui::PopID();
    if (ImGui::GetItemRectMax().x > ImGui::GetWindowPos().x + ImGui::GetWindowWidth() * 0.82f)
      ImGui::NewLine();
  }
  if (!clicked.empty()) dialog.enter(clicked);
}

void drawPlaces(FileDialog& dialog) {
  const char* home = std::getenv("HOME");
  std::error_code error;
  if (home && ImGui::Selectable(tr("Home"))) dialog.enter(home);
  for (const char* name : {"Desktop", "Documents", "Downloads", "Pictures"}) {
    if (!home) break;
    const fs::path place = fs::path(home) / name;
    if (fs::is_directory(place, error) && ImGui::Selectable(tr(name))) dialog.enter(place);
  }
  if (ImGui::Selectable(tr("Computer"))) dialog.enter("/");
  if (dialog.folder.has_parent_path() && ImGui::Selectable(tr("Up one folder")))
    dialog.enter(dialog.folder.parent_path());
}

// Whether the last entry is meant, by a double click or by a key, and not just selected.
bool isMeant() {
  return ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || !ImGui::IsMouseReleased(ImGuiMouseButton_Left);
}

// True when one of the files is meant: the person is done.
bool drawEntries(FileDialog& dialog) {
  bool done = false;
  fs::path entered;
  if (!ImGui::BeginTable("files", 2, ImGuiTableFlags_RowBg)) return false;
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, 90 * unit());
  for (const FileEntry& entry : dialog.entries) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string shown = entry.folder ? entry.name + "/" : entry.name;
    if (entry.folder) ImGui::PushStyleColor(ImGuiCol_Text, colours().accent);
    if (ImGui::Selectable(shown.c_str(), !entry.folder && entry.name == dialog.name,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick)) {
      if (entry.folder && isMeant()) entered = dialog.folder / entry.name;
      if (!entry.folder) {
        dialog.name = entry.name;
        dialog.replaceAsked = false;
        done = isMeant();
      }
    }
    noteWidget("file." + entry.name);
    if (entry.folder) ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    if (!entry.folder) ImGui::TextDisabled("%s", sizeText(entry.bytes).c_str());
  }
  if (dialog.entries.empty()) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", tr("Nothing to choose here"));
  }
  ImGui::EndTable();
  if (!entered.empty()) dialog.enter(entered);
  return done;
}

// The line with the name and the buttons; true when the person wants the file.
bool drawBottom(FileDialog& dialog, const FilePurposeText& text, bool& closed) {
  ImGui::PushTextWrapPos();
  ImGui::TextColored(dialog.replaceAsked ? colours().warning : colours().failure, "%s",
                     dialog.complaint.c_str());
  ImGui::PopTextWrapPos();
  const float button = 92 * unit(), gap = ImGui::GetStyle().ItemSpacing.x;
  if (dialog.opening) ImGui::SetKeyboardFocusHere();
  dialog.opening = false;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * (button + gap));
  bool done =
      ImGui::InputTextWithHint("##name", tr("File name"), &dialog.name, ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) dialog.replaceAsked = false;
  noteWidget("file.name");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button, withAlpha(colours().accent, 0.55f));
  done |= ImGui::Button(trId(dialog.replaceAsked ? "Replace" : text.button).c_str(), {button, 0});
  ImGui::PopStyleColor();
  noteWidget("file.accept");
  ImGui::SameLine();
  closed = ImGui::Button(tr("Cancel"), {button, 0}) ||
           ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  return done;
}

}  // namespace

std::optional<FileChoice> drawFileDialog(FileDialog& dialog) {
  if (!dialog.purpose) return {};
  const FilePurposeText text = purposeText(*dialog.purpose);
  const std::string title = trId(text.title);
  if (dialog.opening) ImGui::OpenPopup(title.c_str());
  const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
  ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({720 * unit(), 480 * unit()});
  std::optional<FileChoice> choice;
  bool closed = false;
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
    return {};
  drawPath(dialog);
  if (ImGui::Checkbox(tr("All files"), &dialog.allFiles)) dialog.enter(dialog.folder);
  const float bottom = 2.15f * ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("places", {130 * unit(), -bottom}, false, ImGuiWindowFlags_NavFlattened);
  drawPlaces(dialog);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("entries", {0, -bottom}, false, ImGuiWindowFlags_NavFlattened);
  bool done = drawEntries(dialog);
  ImGui::EndChild();
  done |= drawBottom(dialog, text, closed);
  if (done) {
    if (const auto path = accept(dialog)) choice = FileChoice{*dialog.purpose, *path};
  }
  if (choice || closed) {
    dialog.purpose.reset();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  return choice;
}

}  // namespace sonoskin::ui
