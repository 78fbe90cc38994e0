#include "app/panels/tour.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>

#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/workspace/commands.h"
#include "app/workspace/tour.h"

namespace sonoskin::ui {
namespace {

using Rect = WidgetRects::Rect;

constexpr float kWidth = 320, kGap = 14;  // of a card, and between it and what it speaks of

Rect windowRect() {
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  return {viewport.Pos, {viewport.Pos.x + viewport.Size.x, viewport.Pos.y + viewport.Size.y}};
}

// Whether all of it is to be seen: what is scrolled away is not.
bool isSeen(const Rect& r) {
  const Rect all = windowRect();
  return r.min.x >= all.min.x && r.min.y >= all.min.y && r.max.x <= all.max.x && r.max.y <= all.max.y;
}

// Around all widgets of a card that are there.
std::optional<Rect> shownBy(const TourCard& card) {
  const auto* rects = static_cast<WidgetRects*>(ImGui::GetIO().UserData);
  std::optional<Rect> all;
  for (const char* name : card.shows) {
    if (!name || !rects) continue;
    const auto found = rects->byName.find(name);
    if (found == rects->byName.end() || !isSeen(found->second)) continue;
    const Rect& r = found->second;
    if (!all) all = r;
    all->min = {std::min(all->min.x, r.min.x), std::min(all->min.y, r.min.y)};
    all->max = {std::max(all->max.x, r.max.x), std::max(all->max.y, r.max.y)};
  }
  return all;
}

float paddedHeight(float contents) { return contents + 2 * ImGui::GetStyle().WindowPadding.y; }

ImVec2 cardSize(const char* text) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float inside = kWidth * unit() - 2 * style.WindowPadding.x;
  const float words = ImGui::CalcTextSize(text, nullptr, false, inside).y;
  return {kWidth * unit(), paddedHeight(ImGui::GetTextLineHeight() + words + ImGui::GetFrameHeight() +
                                        3 * style.ItemSpacing.y + 4 * unit())};
}

// Where a card lies: beside the thing where there is room, else below or above it, else in its corner; without a thing in the
// middle of the window.
ImVec2 cardPlace(const std::optional<Rect>& thing, const ImVec2& size) {
  const Rect all = windowRect();
  const float gap = kGap * unit();
  if (!thing) return {0.5f * (all.min.x + all.max.x - size.x), 0.5f * (all.min.y + all.max.y - size.y)};
  const auto within = [&](ImVec2 p) {
    return ImVec2{std::clamp(p.x, all.min.x + gap, std::max(all.max.x - size.x - gap, all.min.x + gap)),
                  std::clamp(p.y, all.min.y + gap, std::max(all.max.y - size.y - gap, all.min.y + gap))};
  };
  const std::array<ImVec2, 4> places{{{thing->max.x + gap, thing->min.y},
                                      {thing->min.x - gap - size.x, thing->min.y},
                                      {thing->min.x, thing->max.y + gap},
                                      {thing->min.x, thing->min.y - gap - size.y}}};
  const auto apart = [&](const ImVec2& p) {
    return p.x + size.x <= thing->min.x || p.x >= thing->max.x || p.y + size.y <= thing->min.y ||
           p.y >= thing->max.y;
  };
  for (const ImVec2& place : places)
    if (apart(within(place))) return within(place);
  return within({thing->max.x - size.x - gap, thing->max.y - size.y - gap});
}

void frameThing(const Rect& thing) {
  const float out = 3 * unit();
  ImGui::GetForegroundDrawList()->AddRect({thing.min.x - out, thing.min.y - out},
                                          {thing.max.x + out, thing.max.y + out},
                                          ImGui::GetColorU32(colours().accent), 5 * unit(), 0, 2 * unit());
}

// A small window over the others that takes neither the keyboard nor the whole screen.
bool beginCard(const char* id, const ImVec2& place, const ImVec2& size) {
  ImGui::SetNextWindowPos(place);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * unit());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::PushStyleColor(ImGuiCol_Border, colours().accent);
  const bool drawn = ImGui::Begin(id, nullptr,
                                  ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
  return drawn;
}

bool button(const char* text, const char* name, bool enabled = true) {
  const DisabledIf disabled(!enabled);
  const bool pressed = ImGui::Button(text, {84 * unit(), 0});
  noteWidget(name);
  return pressed;
}

void drawText(const char* title, const char* text) {
  ImGui::PushFont(headingFont());
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, 4 * unit() - ImGui::GetStyle().ItemSpacing.y});
}

void drawCard(Workspace& workspace) {
  const std::size_t number = *workspace.help.tour, count = tourCards().size();
  const TourCard& card = tourCards()[number];
  const std::optional<Rect> thing = shownBy(card);
  if (thing) frameThing(*thing);
  const ImVec2 size = cardSize(tr(card.text));
  const ImVec2 place = cardPlace(thing, size);
  if (beginCard("###tour", place, size)) {
    drawText(fmt::format("{}. {}", number + 1, tr(card.title)).c_str(), tr(card.text));
    const bool last = number + 1 == count;
    const bool back = button(tr("Back"), "tour.back", canGoBack(workspace));
    ImGui::SameLine();
    const bool next = button(last ? tr("Done") : tr("Next"), "tour.next");
    ImGui::SameLine();
    const bool ends = !last && button(tr("End tour"), "tour.end");
    if (back) previousCard(workspace);
    if (next) nextCard(workspace);
    if (ends) endTour(workspace);
  }
  ImGui::End();
  noteRect("tour.card", place, {place.x + size.x, place.y + size.y});
}

void drawOffer(Workspace& workspace) {
  const char* text =
      tr("Five steps on a simulated scan show how the window works. It is in the Help menu, too.");
  const ImVec2 size = cardSize(text);
  const Rect all = windowRect();
  if (beginCard("###offer", {all.max.x - size.x - 16 * unit(), all.max.y - size.y - 48 * unit()}, size)) {
    drawText(tr("New here? Take the tour"), text);
    const bool starts = button(tr("Start"), "offer.start");
    ImGui::SameLine();
    const bool goes = button(tr("Not now"), "offer.close");
    if (goes) workspace.help.offered = false;
    if (starts) startTour(workspace);
  }
  ImGui::End();
}

}  // namespace

// Tests have set the user data already, and keep what they want noted.
void TourWindow::lookForWidgets(bool on) {
  void*& noted = ImGui::GetIO().UserData;
  rects_.byName.clear();
  if (on && !noted) noted = &rects_;
  if (!on && noted == &rects_) noted = nullptr;
}

// A row has one frame to be found in.
void TourWindow::lookForRow(std::string& wanted) {
  auto* rects = static_cast<WidgetRects*>(ImGui::GetIO().UserData);
  if (!rects) return;
  if (rects->wanted == wanted) wanted.clear();
  rects->wanted = wanted;
}

void TourWindow::draw(Workspace& workspace) {
  if (workspace.help.offered) drawOffer(workspace);
  if (onTour(workspace)) drawCard(workspace);
  lookForWidgets(onTour(workspace) || !workspace.help.wantedRow.empty());
  lookForRow(workspace.help.wantedRow);
}

}  // namespace sonoskin::ui
