#pragma once

#include <imgui.h>

#include <functional>
#include <string>

namespace sonoskin::ui {

// PlotArea: a rectangle of the window with two axes.
//   left, right   of the horizontal axis; low, high: of the upright one; both positive where it is
//                 logarithmic
struct PlotArea {
  ImVec2 min{}, max{};
  double left = 0, right = 1, low = 0, high = 1;
  bool logarithmic = false;

  // at: where a point is drawn; what lies far outside the axes is drawn half a height beyond their ends.
  ImVec2 at(double x, double y) const;
  // under: the horizontal value below a place of the window.
  double under(float x) const { return left + (right - left) * double((x - min.x) / (max.x - min.x)); }
};

// layOutPlot: takes a place of that height in the current window, with room for labels at the left and, if
// asked for, below; noted under the name.
PlotArea layOutPlot(const std::string& name, float height, bool labelsBelow);

// drawAxes: background, lines and numbers; `below` is the text under the horizontal axis, empty for none.
void drawAxes(const PlotArea& area, const std::string& below);

// drawCurve: a line through `count` points, cut off at the axes; `point` gives them in the units of the axes.
void drawCurve(const PlotArea& area, int count, const std::function<ImVec2(int)>& point, ImU32 colour,
               float thickness);

// tickStep: 1, 2 or 5 times a power of ten, so that about `count` of them fill the span.
double tickStep(double span, int count);

}  // namespace sonoskin::ui
