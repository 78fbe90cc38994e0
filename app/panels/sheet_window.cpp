#include "app/panels/sheet_window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "app/document/command_text.h"
#include "app/panels/dialog_window.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "core/base/error.h"

namespace sonoskin::ui {
namespace {

constexpr float kPlanWidth = 330, kButtonWidth = 150;
constexpr double kBusySeconds = 0.1;

bool button(const char* text, const char* name, float width = kButtonWidth) {
  const bool pressed = ImGui::Button(text, {width * unit(), 0});
  noteWidget(name);
  return pressed;
}

// halved: half as wide and high; a pixel is the mean of four.
Image halved(const Image& image) {
  Image half{image.width / 2, image.height / 2, {}};
  half.rgba.resize(4 * std::size_t(half.width) * std::size_t(half.height));
  const auto row = std::size_t(4 * image.width);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const std::uint8_t* p = &image.rgba[std::size_t(2 * y) * row + std::size_t(8 * x) + c];
        half.rgba[4 * (std::size_t(y) * std::size_t(half.width) + std::size_t(x)) + c] =
            std::uint8_t((p[0] + p[4] + p[row] + p[row + 4] + 2) / 4);
      }
  return half;
}

// The command that makes the same of the recipe that is saved beside it.
std::string commandOf(const SheetOrder& order, const Session& session) {
  CommandText command("sheet");
  command.word(session.isPhantom() ? "phantom" : session.source().string());
  command.option("--out", "sheet.png").option("--recipe", "sheet.recipe.json");
  for (const SheetAxis& axis : order.axes) command.option("--over", sheetWord(axis));
  const ScanView& view = order.view;
  command.option("--view", view.view);
  if (!view.layer.empty()) command.option("--layer", view.layer);
  if (view.view == "slice") command.option("--plane", view.plane);
  if (view.at) command.option("--at", fmt::format("{},{},{}", view.at->x, view.at->y, view.at->z));
  if (view.view == "volume") command.option("--mode", view.volume.mode);
  if (view.view != "slice") command.option("--camera", view.picture.camera);
  command.option("--size", fmt::format("{}x{}", view.picture.size.x, view.picture.size.y));
  return command.text();
}

}  // namespace

double SheetWindow::draw(Workspace& w, const ContextFor& contextFor) {
  for (const std::string& sentence : worker_.poll()) {
    complaint_ = sentence;
    if (!w.sheetShown) w.toasts.add(sentence, true);
  }
  if (opened_ != w.session.opened()) {
    opened_ = w.session.opened();
    worker_.cancel();
    plan_.reset();
    sheet_.reset();
    texture_ = {};
  }
  if (w.sheetShown && w.session.hasScan()) {
    if (beginDialog({tr("Contact sheet"), "###sheet", {1120, 720}}, w.sheetShown)) {
      ImGui::BeginChild("plan", {kPlanWidth * unit(), 0});
      drawPlan(w);
      drawButtons(w, contextFor);
      ImGui::EndChild();
      ImGui::SameLine(0, 16 * unit());
      ImGui::BeginChild("sheet", {0, 0});
      drawSheet(w);
      ImGui::EndChild();
    }
    ImGui::End();
    if (!w.sheetShown && busy())
      w.toasts.add(
          tr("The contact sheet goes on behind the window; File, Contact sheet shows it and can cancel it."),
          false);
  }
  return busy() ? kBusySeconds : -1;
}

void SheetWindow::make(Workspace& w, const ContextFor& contextFor) try {
  complaint_.clear();
  const auto order = std::make_shared<const SheetOrder>(sheetOrder(*plan_, w));
  const auto made = std::make_shared<ContactSheet>();
  const auto image = std::make_shared<Image>();
  worker_.replace({tr("Contact sheet"),
                   [order, made, image, context = contextFor()](const Progress& progress) {
                     *made = makeSheet(*context, *order, progress.part(0, 0.97));
                     *image = pictureOfSheet(*made);
                   },
                   [this, &w, order, made, image, command = commandOf(*order, w.session)] {
                     sheet_ = std::move(*made);
                     axes_ = order->axes;
                     command_ = command;
                     image_ = std::move(*image);
                     stale_ = true;
                     if (!w.sheetShown)
                       w.toasts.add(tr("The contact sheet is made: File, Contact sheet."), false);
                   }});
} catch (const Error& error) {
  complaint_ = error.what();
}

// Not much finer than the screen shows it, or letters and lines would break.
void SheetWindow::upload(float scale) {
  const int halvings = scale > 0.7f ? 0 : scale > 0.35f ? 1 : 2;
  if (!stale_ && halvings == halvings_) return;
  halvings_ = halvings;
  stale_ = false;
  Image shown = image_;
  for (int n = 0; n < halvings; ++n) shown = halved(shown);
  texture_ = gl::Texture({.size = {shown.width, shown.height, 0}});
  texture_.upload(shown.rgba.data());
}

void SheetWindow::take(Workspace& w, std::size_t n) {
  w.session.edit(withValues(w.session.parameters(), axes_, sheet_->cells[n].values));
  w.session.commitEdit();
  for (SheetCell& cell : sheet_->cells) cell.current = &cell == &sheet_->cells[n];
  image_ = pictureOfSheet(*sheet_);
  stale_ = true;  // this frame has the old one in its list
}

void SheetWindow::save(Workspace& w, const std::filesystem::path& path) const {
  require(sheet_.has_value(), "There is no contact sheet to save; make one first.");
  w.session.savePicture(
      path, [path, image = image_](const Progress&) { writePng(path, image); }, false);
}

void SheetWindow::drawButtons(Workspace& w, const ContextFor& contextFor) {
  const Worker::Status status = worker_.status();
  if (status.busy) {
    ImGui::ProgressBar(float(status.fraction), {-1, 0});
    noteWidget("sheet.progress");
    if (button(tr("Cancel"), "sheet.cancel", kPlanWidth)) worker_.cancel();
  } else {
    if (mainButton(tr("Make the sheet"), true)) make(w, contextFor);
    noteWidget("sheet.make");
  }
  if (!complaint_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colours().failure);
    ImGui::TextWrapped("%s", trSentence(complaint_).c_str());
    ImGui::PopStyleColor();
  }
}

void SheetWindow::drawSheet(Workspace& w) {
  if (!sheet_) {
    sentenceText(
        tr("The same picture for each pair of values, side by side. A click on one of them takes its "
           "values over; Ctrl+Z takes that back."));
    return;
  }
  const float lines = 2 * ImGui::GetFrameHeightWithSpacing();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float scale = std::min({room.x / float(image_.width), (room.y - lines) / float(image_.height), 1.0f});
  const ImVec2 shown{scale * float(image_.width), scale * float(image_.height)};
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, (room.x - shown.x) / 2));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  upload(scale);
  ImGui::Image(reinterpret_cast<ImTextureID>(std::uintptr_t(texture_.name())), shown);
  noteWidget("sheet.picture");
  drawCells(w, {corner.x, corner.y}, scale);
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - lines);
  ImGui::TextDisabled("%s", tr("A click takes the values of a picture over."));
  if (button(tr("Save..."), "sheet.save"))
    w.files.ask(FilePurpose::saveSheet, w.settings.folder, "sheet.png");
  ImGui::SameLine();
  if (button(tr("Copy command"), "sheet.copy")) ImGui::SetClipboardText(command_.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", command_.c_str());
}

// A frame around the cell below the mouse, which is the one that a click takes.
void SheetWindow::drawCells(Workspace& w, glm::vec2 corner, float scale) {
  const ImVec2 mouse = ImGui::GetMousePos();
  const auto hovered = ImGui::IsItemHovered()
                           ? sheet_->layout.at((glm::vec2(mouse.x, mouse.y) - corner) / scale)
                           : std::nullopt;
  for (std::size_t n = 0; n < sheet_->cells.size(); ++n) {
    const glm::vec2 from = corner + scale * glm::vec2(sheet_->layout.corner(n));
    const glm::vec2 to = from + scale * glm::vec2(sheet_->layout.cell);
    noteRect(fmt::format("sheet.cell.{}", n), {from.x, from.y}, {to.x, to.y});
    if (hovered != n) continue;
    ImGui::GetWindowDrawList()->AddRect({from.x, from.y}, {to.x, to.y}, ImGui::GetColorU32(kAccent), 0, 0,
                                        2 * unit());
    const SheetCell& cell = sheet_->cells[n];
    ImGui::SetTooltip("%s", (cell.failure.empty() ? cell.text : cell.failure).c_str());
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) take(w, n);
  }
}

}  // namespace sonoskin::ui
