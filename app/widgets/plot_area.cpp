#include "app/widgets/plot_area.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

std::vector<double> ticks(double from, double to, int count) {
  const double step = tickStep(to - from, count);
  std::vector<double> values;
  for (double i = std::ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; ++i)
    values.push_back(i * step + 0.0);  // 0, not -0
  return values;
}

std::vector<double> decades(double from, double to) {
  std::vector<double> values;
  for (double e = std::ceil(std::log10(from) - 1e-9); e <= std::log10(to) + 1e-9; ++e)
    values.push_back(std::pow(10, e));
  return values;
}

void drawNumber(ImVec2 place, ImVec2 anchor, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetWindowDrawList()->AddText({place.x - anchor.x * size.x, place.y - anchor.y * size.y},
                                      ImGui::GetColorU32(colours().faintText), text.c_str());
}

void drawUprightAxis(const PlotArea& area, ImU32 line) {
  const auto values = area.logarithmic ? decades(area.low, area.high) : ticks(area.low, area.high, 4);
  for (double y : values) {
    const ImVec2 left = area.at(area.left, y), right = area.at(area.right, y);
    ImGui::GetWindowDrawList()->AddLine(left, right, line);
    drawNumber({left.x - 4 * unit(), left.y}, {1, 0.5f}, fmt::format("{:g}", y));
  }
}

}  // namespace

double tickStep(double span, int count) {
  const double raw = span / count, power = std::pow(10, std::floor(std::log10(raw)));
  for (double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw * 0.999) return factor * power;
  return 10 * power;
}

ImVec2 PlotArea::at(double x, double y) const {
  double up = (y - low) / (high - low);
  if (logarithmic) up = std::log(std::max(y, 1e-300) / low) / std::log(high / low);
  const double across = (x - left) / (right - left);
  return {min.x + float(std::clamp(across, 0.0, 1.0)) * (max.x - min.x),
          max.y - float(std::clamp(up, -0.5, 1.5)) * (max.y - min.y)};
}

PlotArea layOutPlot(const std::string& name, float height, bool labelsBelow) {
  const float margin = 46 * unit(), bottom = labelsBelow ? 34 * unit() : 6 * unit();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, margin + 60 * unit());
  ImGui::InvisibleButton(name.c_str(), {width, height + bottom});
  noteWidget(name);
  PlotArea area;
  area.min = {corner.x + margin, corner.y + 4 * unit()};
  area.max = {corner.x + width - 6 * unit(), corner.y + height};
  return area;
}

void drawAxes(const PlotArea& area, const std::string& below) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 line = ImGui::GetColorU32(ImGuiCol_Separator, 0.6f);
  list.AddRectFilled(area.min, area.max, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5f));
  ImGui::PushFont(smallFont());
  drawUprightAxis(area, line);
  for (double x : ticks(area.left, area.right, 5)) {
    const ImVec2 top{area.at(x, area.high).x, area.min.y}, foot{top.x, area.max.y};
    list.AddLine(top, foot, line);
    if (!below.empty()) drawNumber({foot.x, foot.y + 3 * unit()}, {0.5f, 0}, fmt::format("{:g}", x));
  }
  if (!below.empty()) drawNumber({(area.min.x + area.max.x) / 2, area.max.y + 17 * unit()}, {0.5f, 0}, below);
  ImGui::PopFont();
}

void drawCurve(const PlotArea& area, int count, const std::function<ImVec2(int)>& point, ImU32 colour,
               float thickness) {
  std::vector<ImVec2> places;
  for (int i = 0; i < count; ++i) {
    const ImVec2 p = point(i);
    places.push_back(area.at(double(p.x), double(p.y)));
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(area.min, area.max, true);
  list.AddPolyline(places.data(), count, colour, 0, thickness * unit());
  list.PopClipRect();
}

}  // namespace sonoskin::ui
