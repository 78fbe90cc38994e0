// What the dialog of the contact sheet asks.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/sheet_window.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "core/base/error.h"

namespace sonoskin::ui {
namespace {

constexpr int kFewest = 2, kMost = 12;  // values of an axis
constexpr std::array kWidths{160, 240, 320, 480, 640};

void editNumber(const std::string& name, double& value, const SheetNumber& number) {
  ImGui::SetNextItemWidth(-1);
  ImGui::InputDouble(("##" + name).c_str(), &value, 0, 0, "%.5g");
  noteWidget("sheet." + name);
  if (ImGui::IsItemDeactivatedAfterEdit()) value = std::clamp(value, number.range.min, number.range.max);
}

// The parameter that was chosen in the list; null for none.
const SheetNumber* chooseNumber(const std::string& name, const std::vector<SheetNumber>& numbers,
                                std::string& parameter, bool mayBeNone) {
  const auto chosen = std::ranges::find(numbers, parameter, &SheetNumber::name);
  const SheetNumber* pressed = nullptr;
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo(("##" + name).c_str(),
                                      chosen == numbers.end() ? tr("Nothing") : chosen->title.c_str());
  noteWidget("sheet." + name);
  if (!open) return nullptr;
  if (mayBeNone && ImGui::Selectable(tr("Nothing"), parameter.empty())) parameter.clear();
  for (const SheetNumber& number : numbers) {
    if (ImGui::Selectable(number.title.c_str(), number.name == parameter)) pressed = &number;
    noteWidget("sheet." + name + "." + number.name);
  }
  ImGui::EndCombo();
  return pressed;
}

}  // namespace

void SheetWindow::drawAxis(std::size_t a, const std::vector<SheetNumber>& numbers) {
  SheetRange& range = plan_->axes[a];
  const std::string suffix = std::to_string(a + 1);
  heading(a == 0 ? tr("To the right") : tr("Down"));
  if (const SheetNumber* chosen = chooseNumber("parameter" + suffix, numbers, range.parameter, a == 1))
    range = usualRange(*chosen);
  const auto number = std::ranges::find(numbers, range.parameter, &SheetNumber::name);
  if (number == numbers.end() || !beginFields(("axis" + suffix).c_str())) return;
  beginRow(tr("From"));
  editNumber("from" + suffix, range.from, *number);
  beginRow(tr("To"));
  editNumber("to" + suffix, range.to, *number);
  beginRow(tr("Values"));
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderInt(("##count" + suffix).c_str(), &range.count, kFewest, kMost, "%d",
                   ImGuiSliderFlags_AlwaysClamp);
  noteWidget("sheet.count" + suffix);
  endFields();
}

void SheetWindow::drawPicture(Workspace& w) {
  heading(tr("Each picture"));
  if (!beginFields("picture")) return;
  const std::array shown{tr("Slice: classified"), tr("Slice: surface voxels"), tr("Classified volume in 3D"),
                         tr("Surface"), tr("Skin")};
  beginRow(tr("Shows"));
  ImGui::SetNextItemWidth(-1);
  int picture = int(plan_->picture);
  ImGui::Combo("##shows", &picture, shown.data(), int(shown.size()));
  noteWidget("sheet.shows");
  plan_->picture = SheetPicture(picture);
  if (plan_->picture <= SheetPicture::thinned) {
    const ViewFrame frame = w.viewFrame();
    beginRow(tr("Plane"));
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##plane", tr(planeName(frame, plan_->plane)))) {
      for (const Plane plane : kPlanes)
        if (ImGui::Selectable(tr(planeName(frame, plane)), plane == plan_->plane)) plan_->plane = plane;
      ImGui::EndCombo();
    }
    noteWidget("sheet.plane");
  }
  beginRow(tr("Size"));
  ImGui::SetNextItemWidth(-1);
  const auto sizeText = [](int width) { return fmt::format("{} x {}", width, 3 * width / 4); };
  if (ImGui::BeginCombo("##size", sizeText(plan_->width).c_str())) {
    for (const int width : kWidths)
      if (ImGui::Selectable(sizeText(width).c_str(), width == plan_->width)) plan_->width = width;
    ImGui::EndCombo();
  }
  noteWidget("sheet.size");
  endFields();
}

void SheetWindow::drawPlan(Workspace& w) {
  const std::vector<SheetNumber> numbers = sheetNumbers(w.session.parameters(), w.session.results());
  if (!plan_) plan_ = usualPlan(numbers);
  for (std::size_t a = 0; a < plan_->axes.size(); ++a) drawAxis(a, numbers);
  drawPicture(w);
  ImGui::Spacing();
  try {
    const SheetOrder order = sheetOrder(*plan_, w);
    const SheetLayout layout = sheetLayout(order.axes, order.view.picture.size);
    std::size_t count = 1;
    for (const SheetAxis& axis : order.axes) count *= axis.values.size();
    ImGui::TextDisabled("%s", fmt::format(fmt::runtime(tr("{} pictures, {} x {} pixels in all")), count,
                                          layout.size().x, layout.size().y)
                                  .c_str());
  } catch (const Error& error) {
    ImGui::TextWrapped("%s", trSentence(error.what()).c_str());
  }
}

}  // namespace sonoskin::ui
