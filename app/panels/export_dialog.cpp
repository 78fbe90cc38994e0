#include "app/panels/export_dialog.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/panels/dialog_window.h"
#include "app/panels/picture_format_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

constexpr float kListWidth = 190, kButtonWidth = 110;

bool button(const char* text, const char* name, float width = kButtonWidth) {
  const bool pressed = ImGui::Button(text, {width * unit(), 0});
  noteWidget(name);
  return pressed;
}

void coloured(const ImVec4& colour, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

bool isPicture(const ExportPlan& plan) {
  return plan.what().purpose == FilePurpose::savePicture || plan.what().purpose == FilePurpose::saveTurntable;
}

bool replaces(const std::vector<ExportFile>& files) {
  return std::ranges::any_of(files, [](const ExportFile& file) { return file.exists; });
}

}  // namespace

void ExportDialog::begin(const Workspace& w) {
  if (!plan_) {
    plan_.emplace();
    const auto available =
        std::ranges::find_if(exportItems(), [&](const ExportItem& item) { return item.available(w); });
    if (available != exportItems().end()) chooseItem(*plan_, std::size_t(available - exportItems().begin()));
  }
  std::error_code error;
  plan_->folder = std::filesystem::is_directory(w.settings.folder, error)
                      ? w.settings.folder
                      : std::filesystem::current_path(error);
  changed();
}

bool ExportDialog::takes(const FileChoice& choice) {
  if (!std::exchange(browsing_, false)) return false;
  plan_->folder = choice.path.parent_path();
  plan_->name = choice.path.filename().string();
  replaceAsked_ = true;  // the file dialog has asked
  return true;
}

std::optional<FileChoice> ExportDialog::draw(Workspace& w) {
  if (browsing_ && !w.files.purpose) browsing_ = false;
  if (!std::exchange(shown_, w.exportShown) && w.exportShown) begin(w);
  if (!w.exportShown) return {};
  bool wanted = false;
  if (beginDialog({tr("Export"), "###export", {880, 620}}, w.exportShown)) {
    ImGui::BeginChild("items", {kListWidth * unit(), 0});
    drawItems(w);
    ImGui::EndChild();
    ImGui::SameLine(0, 16 * unit());
    ImGui::BeginChild("plan", {0, 0});
    sentenceText(tr(plan_->what().help));
    ImGui::Spacing();
    if (beginFields("export")) {
      drawPlace(w);
      drawFormat();
      drawPlacement();
      endFields();
    }
    if (isPicture(*plan_))
      drawPictureFormat(w.pictureFormat, plan_->what().purpose == FilePurpose::saveTurntable);
    drawFiles(w);
    drawCommand(w);
    wanted = drawButtons(w);
    ImGui::EndChild();
  }
  ImGui::End();
  if (!wanted) return {};
  w.exportShown = false;
  return FileChoice{plan_->what().purpose, plan_->path(), plan_->placement};
}

void ExportDialog::drawItems(const Workspace& w) {
  for (std::size_t n = 0; n < exportItems().size(); ++n) {
    const ExportItem& item = exportItems()[n];
    ImGui::PushStyleColor(ImGuiCol_Text, item.available(w) ? colours().text : colours().faintText);
    if (ImGui::Selectable(tr(item.title), n == plan_->item) && n != plan_->item) {
      chooseItem(*plan_, n);
      changed();
    }
    ImGui::PopStyleColor();
    noteWidget(std::string("export.") + item.id);
  }
}

void ExportDialog::drawPlace(Workspace& w) {
  beginRow(tr("Name"));
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##name", &plan_->name)) changed();
  noteWidget("export.name");
  beginRow(tr("Folder"));
  const float width = 100 * unit();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - width - ImGui::GetStyle().ItemSpacing.x);
  std::string folder = plan_->folder.string();
  if (ImGui::InputText("##folder", &folder)) {
    plan_->folder = folder;
    changed();
  }
  noteWidget("export.folder");
  ImGui::SameLine();
  if (button(tr("Browse..."), "export.browse", 100)) {
    w.files.ask(plan_->what().purpose, plan_->folder, plan_->name);
    browsing_ = true;
  }
}

void ExportDialog::drawFormat() {
  const std::string ending = endingOf(*plan_);
  const std::vector<ExportFormat> formats = exportFormats(plan_->what());
  const auto title = [](const ExportFormat& f) { return fmt::format("{} ({})", f.name, f.ending); };
  const auto chosen = std::ranges::find(formats, ending, &ExportFormat::ending);
  const bool known = chosen != formats.end();
  beginRow(tr("Format"));
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##format", known ? title(*chosen).c_str() : "");
  noteWidget("export.format");
  if (open) {
    for (const ExportFormat& format : formats) {
      if (ImGui::Selectable((title(format) + ": " + format.keeps).c_str(), format.ending == ending)) {
        chooseEnding(*plan_, format.ending);
        changed();
      }
      noteWidget("export.format" + format.ending);
    }
    ImGui::EndCombo();
  }
  beginRow("");
  coloured(colours().faintText, known ? chosen->keeps : std::string(" "));
}

void ExportDialog::drawPlacement() {
  if (placementChoosable(*plan_)) {
    MeshPlacement& placement = plan_->placement;
    int frame = int(placement.frame), unitOf = int(placement.unit);
    beginRow(tr("Frame"));
    segments("frame", {"LPS (DICOM, ITK)", "RAS"}, frame);
    noteWidget("export.frame");
    beginRow(tr("Unit"));
    segments("unit", {"mm", "m"}, unitOf);
    noteWidget("export.unit");
    placement = {MeshFrame(frame), MeshUnit(unitOf)};
    return;
  }
  const std::string words = placementWords(*plan_);
  if (words.empty()) return;
  beginRow(tr("Frame"));
  ImGui::TextDisabled("%s", words.c_str());
}

void ExportDialog::drawFiles(const Workspace& w) const {
  heading(tr("What is written"));
  if (endingOf(*plan_).empty()) return;
  for (const ExportFile& file : exportFiles(*plan_, w.pictureFormat)) {
    std::string line = file.name;
    if (!file.more.empty()) line = fmt::format(fmt::runtime(tr("{} to {}")), file.name, file.more);
    if (file.exists && plan_->what().purpose == FilePurpose::saveTurntable)
      coloured(colours().warning, fmt::format(fmt::runtime(tr("{}: is there already")), line));
    else if (file.exists)
      coloured(colours().warning,
               fmt::format(fmt::runtime(tr("{}: is there already and will be replaced")), line));
    else
      ImGui::TextUnformatted(line.c_str());
  }
}

void ExportDialog::drawCommand(const Workspace& w) const {
  heading(tr("The same from a command line"));
  const std::string command = exportCommand(*plan_, w);
  ImGui::PushFont(smallFont());
  coloured(colours().faintText, command);
  ImGui::PopFont();
  if (button(tr("Copy"), "export.copy")) ImGui::SetClipboardText(command.c_str());
}

// True when everything is said and the person wants it.
bool ExportDialog::drawButtons(Workspace& w) {
  const std::string complaint = complaintOf(*plan_, w);
  const bool asks = complaint.empty() && replaces(exportFiles(*plan_, w.pictureFormat));
  ImGui::SetCursorPosY(
      std::max(ImGui::GetCursorPosY(), ImGui::GetWindowHeight() - 2 * ImGui::GetFrameHeightWithSpacing()));
  if (!complaint.empty())
    coloured(colours().failure, complaint);
  else if (asks && replaceAsked_)
    coloured(colours().warning,
             tr("Files of these names are there already; press Replace to write over them."));
  else
    ImGui::Dummy({0, ImGui::GetTextLineHeight()});
  if (button(tr("Cancel"), "export.cancel")) w.exportShown = false;
  ImGui::SameLine();
  const DisabledIf disabled(!complaint.empty());
  ImGui::PushStyleColor(ImGuiCol_Button, withAlpha(colours().accent, 0.55f));
  const bool pressed = button(asks && replaceAsked_ ? tr("Replace") : tr("Export"), "export.accept");
  ImGui::PopStyleColor();
  if (!pressed) return false;
  return !asks || std::exchange(replaceAsked_, true);
}

}  // namespace sonoskin::ui
