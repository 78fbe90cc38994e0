#include "app/panels/sheet_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/widgets/fields_ui.h"

namespace sonoskin::ui {
namespace {

constexpr std::array<std::string_view, 4> kFirst{"classification.beta", "classification.isoValue",
                                                 "classification.alpha", "classification.gamma"};
constexpr std::array<std::string_view, 8> kGroups{
    "enhancement", "classification", "surface", "reconstruction", "global", "mesh", "skin", "light"};
constexpr std::array<const char*, 3> kPlaneWords{"sagittal", "coronal", "axial"};  // by Plane

template <class T>
void addNumber(std::vector<SheetNumber>& list, const std::string& name, const Field& field, const T& value,
               const Range<T>& range) {
  const std::string symbol = greekSymbol(field.symbol);
  list.push_back({name,
                  symbol.empty() ? name : fmt::format("{}   {}", symbol, name),
                  {double(range.min), double(range.max), range.logarithmic},
                  std::is_integral_v<T>,
                  double(value)});
}

std::size_t placeOf(const SheetNumber& number) {
  return std::size_t(std::ranges::find(kFirst, number.name) - kFirst.begin());
}

double valueAt(const SheetNumber& number, const SheetRange& range, int step) {
  const double share = range.count > 1 ? double(step) / (range.count - 1) : 0;
  const bool factors = number.range.logarithmic && range.from > 0 && range.to > 0;
  double value = factors ? range.from * std::pow(range.to / range.from, share)
                         : range.from + share * (range.to - range.from);
  value = number.whole ? std::round(value) : roundedForSlider(value);
  return std::clamp(value, number.range.min, number.range.max);
}

}  // namespace

std::vector<SheetNumber> sheetNumbers(const Parameters& parameters, const Results& results) {
  std::vector<SheetNumber> list;
  forEachField(
      [&](const Group& group, const Field& field, const auto& value, const auto&... range) {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>> && sizeof...(range) == 1)
          if (std::ranges::count(kGroups, group.name) > 0)
            addNumber(list, fmt::format("{}.{}", group.name, field.name), field, value, range...);
      },
      parameters);
  for (SheetNumber& number : list)
    if (number.name == "classification.isoValue" && number.value == 0)
      number.value = results.isoValue > 0 ? roundedForSlider(results.isoValue) : 0.3;
  std::ranges::stable_sort(list, {}, placeOf);
  return list;
}

SheetRange usualRange(const SheetNumber& number) {
  const double value = number.value, width = number.range.max - number.range.min;
  SheetRange range{number.name, value / 2, value * (number.range.logarithmic ? 2 : 1.5)};
  if (value == 0) range = {number.name, 0, width / 4};
  if (range.from > range.to) std::swap(range.from, range.to);
  range.from = std::clamp(range.from, number.range.min, number.range.max);
  range.to = std::clamp(range.to, number.range.min, number.range.max);
  return range;
}

SheetAxis axisOf(const SheetNumber& number, const SheetRange& range, const Parameters& parameters) {
  std::vector<double> values;
  for (int step = 0; step < range.count; ++step)
    if (const double value = valueAt(number, range, step); std::ranges::count(values, value) == 0)
      values.push_back(value);
  const auto nearest =
      std::ranges::min_element(values, {}, [&](double v) { return std::abs(v - number.value); });
  const auto [least, most] = std::ranges::minmax(values);
  const bool between = number.value >= least && number.value <= most;
  if (between) *nearest = number.value;
  std::string text = range.parameter + "=";
  for (const double& value : values) text += fmt::format("{}{}", &value == values.data() ? "" : ",", value);
  SheetAxis axis = sheetAxis(parameters, text);
  if (between) axis.current = std::size_t(nearest - values.begin());
  return axis;
}

SheetPlan usualPlan(const std::vector<SheetNumber>& numbers) {
  SheetPlan plan;
  for (std::size_t a = 0; a < 2; ++a) plan.axes[a] = usualRange(numbers.at(a));
  return plan;
}

ScanView sheetView(const SheetPlan& plan, const glm::dvec3& cursor) {
  ScanView view;
  view.picture.size = {plan.width, 3 * plan.width / 4};
  if (plan.picture == SheetPicture::classified || plan.picture == SheetPicture::thinned) {
    view.view = "slice";
    view.layer = plan.picture == SheetPicture::thinned ? "thinned" : "classified";
    view.plane = kPlaneWords[std::size_t(plan.plane)];
    // To a hundredth of a millimetre, as a command line can say it.
    view.at = glm::round(cursor * 100.0) / 100.0;
    return view;
  }
  view.picture.camera = "face";
  view.view = plan.picture == SheetPicture::volume ? "volume"
              : plan.picture == SheetPicture::mesh ? "mesh"
                                                   : "skin";
  if (plan.picture != SheetPicture::volume) return view;
  view.layer = "classified";
  view.volume.mode = "iso";
  return view;
}

SheetOrder sheetOrder(const SheetPlan& plan, const Workspace& w) {
  const Session& session = w.session;
  SheetOrder order{session.scan(), session.parameters(), {}, sheetView(plan, w.view.cursor)};
  const std::vector<SheetNumber> numbers = sheetNumbers(order.parameters, session.results());
  for (const SheetRange& range : plan.axes) {
    const auto number = std::ranges::find(numbers, range.parameter, &SheetNumber::name);
    if (number != numbers.end()) order.axes.push_back(axisOf(*number, range, order.parameters));
  }
  sheetLayout(order.axes, order.view.picture.size);
  return order;
}

}  // namespace sonoskin::ui
