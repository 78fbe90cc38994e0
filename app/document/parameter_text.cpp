#include "app/document/parameter_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/error.h"
#include "core/base/shown_text.h"

namespace sonoskin {
namespace {

template <class T, std::size_t n>
constexpr char separator(const std::array<T, n>&) {
  return std::is_integral_v<T> ? 'x' : ',';
}

// Text of a value. Numbers in the shortest form that reads back to the same number.
std::string textOf(bool value) { return value ? "on" : "off"; }
std::string textOf(int value) { return fmt::format("{}", value); }
std::string textOf(double value) { return fmt::format("{}", value); }
template <NamedEnum E>
std::string textOf(E value) {
  return enumNames(value)[std::size_t(value)];
}
template <class T>
std::string textOf(const std::array<T, 3>& v) {
  const char s = separator(v);
  return fmt::format("{}{}{}{}{}", v[0], s, v[1], s, v[2]);
}

std::string textOf(const Places& places) {
  if (places.empty()) return "none";
  std::string text;
  for (const auto& place : places) {
    if (!text.empty()) text += ';';
    text += textOf(place);
  }
  return text;
}

// What a value looks like.
std::string kindOf(bool) { return "on|off"; }
std::string kindOf(int) { return "INTEGER"; }
std::string kindOf(double) { return "NUMBER"; }
template <NamedEnum E>
std::string kindOf(E value) {
  return fmt::format("{}", fmt::join(enumNames(value), "|"));
}
std::string kindOf(const std::array<int, 3>&) { return "NxNxN"; }
std::string kindOf(const std::array<double, 3>&) { return "X,Y,Z"; }
std::string kindOf(const Places&) { return "X,Y,Z;..."; }

std::string kindInWords(const std::string& kind) {
  if (kind == "NUMBER") return "a number";
  return kind == "INTEGER" ? "a whole number" : kind;
}

// parse: the value of a text, or nothing where the text is not of the member's kind.
template <class T>
requires std::is_arithmetic_v<T> std::optional<T> parse(std::string_view text, T) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(value)) return std::nullopt;
  }
  return value;
}
std::optional<bool> parse(std::string_view text, bool) {
  if (text == "on" || text == "true" || text == "1") return true;
  if (text == "off" || text == "false" || text == "0") return false;
  return std::nullopt;
}
template <NamedEnum E>
std::optional<E> parse(std::string_view text, E like) {
  const auto names = enumNames(like);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (text == names[i]) return E(i);
  return std::nullopt;
}
template <class T>
std::optional<std::array<T, 3>> parse(std::string_view text, const std::array<T, 3>& like) {
  std::array<T, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t cut = i < 2 ? text.find(separator(like)) : text.size();
    if (cut == std::string_view::npos) return std::nullopt;
    const auto value = parse(text.substr(0, cut), T{});
    if (!value) return std::nullopt;
    values[i] = *value;
    text.remove_prefix(i < 2 ? cut + 1 : cut);
  }
  return values;
}

// Places with semicolons between them, or "none".
std::optional<Places> parse(std::string_view text, const Places&) {
  Places places;
  if (text == "none") return places;
  if (text.empty() || text.back() == ';') return std::nullopt;
  while (!text.empty()) {
    const std::size_t cut = std::min(text.find(';'), text.size());
    const auto place = parse(text.substr(0, cut), std::array<double, 3>{});
    if (!place) return std::nullopt;
    places.push_back(*place);
    text.remove_prefix(std::min(cut + 1, text.size()));
  }
  return places;
}

template <class T>
bool within(T value, const Range<T>& range) {
  return value >= range.min && value <= range.max;
}
template <class T>
bool within(const std::array<T, 3>& values, const Range<T>& range) {
  return within(values[0], range) && within(values[1], range) && within(values[2], range);
}

bool within(const Places& places, const Range<double>& range) {
  return std::all_of(places.begin(), places.end(), [&](const auto& place) { return within(place, range); });
}

template <class T>
void assign(std::string_view name, std::string_view text, T& member) {
  const auto value = parse(text, member);
  if (!value) {
    const std::string example = textOf(member) == "none" ? "12,-3.5,40;8,0,61" : textOf(member);
    throw Error(fmt::format("--{} {} is not {}; give for example {}.", name, shownText(text),
                            kindInWords(kindOf(member)), example),
                Error::Kind::usage);
  }
  member = *value;
}
template <class T, class N>
void assign(std::string_view name, std::string_view text, T& member, const Range<N>& range) {
  T value = member;
  assign(name, text, value);
  if (!within(value, range)) {
    throw Error(fmt::format("--{} {} lies outside of {} .. {}; give a value within.", name, shownText(text),
                            range.min, range.max),
                Error::Kind::usage);
  }
  member = value;
}

std::string rangeText() { return {}; }
template <class N>
std::string rangeText(const Range<N>& range) {
  return fmt::format("{} .. {}", range.min, range.max);
}

}  // namespace

std::vector<ParameterInfo> describeParameters(const Parameters& parameters) {
  std::vector<ParameterInfo> list;
  forEachField(
      [&](const Group& group, const Field& field, const auto& member, const auto&... range) {
        list.push_back({fmt::format("{}.{}", group.name, field.name),
                        fmt::format("{}: {}", group.name, group.help), std::string(field.help),
                        std::string(field.unit), std::string(field.symbol), kindOf(member),
                        rangeText(range...), textOf(member)});
      },
      parameters);
  return list;
}

void setParameter(Parameters& parameters, std::string_view name, std::string_view text) {
  bool found = false;
  forEachField(
      [&](const Group& group, const Field& field, auto& member, const auto&... range) {
        if (found || fmt::format("{}.{}", group.name, field.name) != name) return;
        found = true;
        assign(name, text, member, range...);
      },
      parameters);
  if (!found) {
    throw Error(
        fmt::format("There is no parameter --{}; \"sonoskin recipe --explain\" lists them.", shownText(name)),
        Error::Kind::usage);
  }
}

ParameterInfo findParameter(const Parameters& parameters, std::string_view word) {
  const std::vector<ParameterInfo> all = describeParameters(parameters);
  const auto fits = [&](const auto& test) {
    std::vector<ParameterInfo> found;
    std::ranges::copy_if(all, std::back_inserter(found), test);
    return found;
  };
  auto found = fits([&](const ParameterInfo& p) { return p.name == word; });
  if (found.empty())
    found = fits([&](const ParameterInfo& p) { return p.name.ends_with("." + std::string(word)); });
  if (found.empty()) found = fits([&](const ParameterInfo& p) { return !word.empty() && p.symbol == word; });
  if (found.empty())
    throw Error(
        fmt::format("There is no parameter {}; \"sonoskin recipe --explain\" lists them.", shownText(word)),
        Error::Kind::usage);
  if (found.size() > 1)
    throw Error(fmt::format("{} may be {} or {}; give the whole name.", word, found[0].name, found[1].name),
                Error::Kind::usage);
  return found.front();
}

}  // namespace sonoskin
