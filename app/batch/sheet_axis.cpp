#include "app/batch/sheet_axis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/document/parameter_text.h"
#include "app/widgets/fields_ui.h"
#include "core/base/error.h"
#include "core/base/shown_text.h"

namespace sonoskin {
namespace {

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string symbolOf(const ParameterInfo& parameter) {
  if (!parameter.symbol.empty()) return ui::greekSymbol(parameter.symbol);
  const std::string name = parameter.name.substr(parameter.name.find('.') + 1);
  return ui::fieldLabel(Field{name, ""});
}

// The text of the value that a cell would have.
std::string valueText(Parameters parameters, const std::string& name, const std::string& text,
                      const std::string& over) try {
  setParameter(parameters, name, text);
  return findParameter(parameters, name).value;
} catch (const Error& error) {
  // It names the parameter as an option of its own, which nobody gave here.
  const std::string option = fmt::format("--{} {} ", name, shownText(text)), why = error.what();
  if (!why.starts_with(option)) throw;
  throw Error(
      fmt::format("--over {}: \"{}\" {}", shownText(over), shownText(text), why.substr(option.size())),
      error.kind());
}

// Whether two texts are the same value: the same words, or numbers like 0 and -0.
bool areSame(const std::string& a, const std::string& b) {
  const auto number = [](const std::string& text) {
    double value = std::nan("");
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failure == std::errc() && end == text.data() + text.size() ? value : std::nan("");
  };
  return a == b || number(a) == number(b);
}

}  // namespace

SheetAxis sheetAxis(const Parameters& parameters, const std::string& text) {
  const auto endWith = [&](const std::string& why) {
    throw Error(fmt::format("--over {} {}", shownText(text), why), Error::Kind::usage);
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size())
    endWith("names no values; give for example beta=0.5,1,2.");
  const ParameterInfo parameter = findParameter(parameters, text.substr(0, equals));
  if (parameter.kind.find(',') != std::string::npos || parameter.kind.find("xN") != std::string::npos)
    endWith("is a parameter of several numbers; a sheet varies one number, or a choice.");
  for (const char* group : {"phantom.", "scan.", "raw."})
    if (parameter.name.starts_with(group))
      endWith("says which scan it is and how it is read; a sheet varies what is made of it.");
  SheetAxis axis{parameter.name, symbolOf(parameter), {}};
  for (const std::string& value : splitAtCommas(text.substr(equals + 1))) {
    const std::string read = valueText(parameters, axis.parameter, value, text);
    if (std::ranges::any_of(axis.values, [&](const auto& other) { return areSame(other, read); }))
      endWith(fmt::format("has {} twice; name it once.", read));
    if (areSame(read, parameter.value)) axis.current = axis.values.size();
    axis.values.push_back(read);
  }
  if (axis.values.size() > kMostValues)
    endWith(fmt::format("has {} values; give {} at most.", axis.values.size(), kMostValues));
  return axis;
}

std::string sheetWord(const SheetAxis& axis) {
  return fmt::format("{}={}", axis.parameter, fmt::join(axis.values, ","));
}

std::string cellText(const std::vector<SheetAxis>& axes, const std::vector<std::size_t>& values) {
  std::string text;
  for (std::size_t a = 0; a < axes.size(); ++a)
    text += fmt::format("{}{} {}", a > 0 ? "   " : "", axes[a].symbol, axes[a].values[values[a]]);
  return text;
}

Parameters withValues(Parameters parameters, const std::vector<SheetAxis>& axes,
                      const std::vector<std::size_t>& values) {
  for (std::size_t a = 0; a < axes.size(); ++a)
    setParameter(parameters, axes[a].parameter, axes[a].values[values[a]]);
  return parameters;
}

}  // namespace sonoskin
