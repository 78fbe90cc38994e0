#include "core/io/headers/units.h"

#include <map>
#include <string>

#include "core/base/log.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace {

using Units = std::map<std::string, double, std::less<>>;

// The micro sign and the Greek letter in UTF-8, and the sign in Latin-1, become "u".
std::string plainWord(std::string_view unit) {
  std::string word = lowerCase(trimmed(unit));
  for (const std::string_view micro : {"\xc2\xb5", "\xce\xbc", "\xb5"})
    if (word.starts_with(micro)) return "u" + word.substr(micro.size());
  return word;
}

std::optional<double> look(const Units& units, std::string_view unit) {
  std::string word = plainWord(unit);
  auto found = units.find(word);
  if (found == units.end() && word.size() > 3 && word.ends_with('s')) {
    word.pop_back();
    found = units.find(word);
  }
  if (found == units.end()) return {};
  return found->second;
}

}  // namespace

std::optional<double> millimetresIn(std::string_view unit) {
  static const Units units{{"nm", 1e-6},       {"nanometer", 1e-6},  {"nanometre", 1e-6},  {"um", 1e-3},
                           {"micron", 1e-3},   {"micrometer", 1e-3}, {"micrometre", 1e-3}, {"mm", 1},
                           {"millimeter", 1},  {"millimetre", 1},    {"cm", 10},           {"centimeter", 10},
                           {"centimetre", 10}, {"dm", 100},          {"decimeter", 100},   {"decimetre", 100},
                           {"m", 1000},        {"meter", 1000},      {"metre", 1000},      {"in", 25.4},
                           {"inch", 25.4},     {"inches", 25.4},     {"\"", 25.4},         {"ft", 304.8},
                           {"foot", 304.8},    {"feet", 304.8}};
  return look(units, unit);
}

double millimetresOrWarn(std::string_view unit) {
  const std::string_view word = trimmed(unit);
  if (word.empty() || word == "?" || word == "??" || word == "???") return 1;
  const auto known = millimetresIn(word);
  if (!known)
    log(LogLevel::warning,
        "The unit of length in the header is not known here; its lengths are taken for millimetres.");
  return known.value_or(1);
}

std::optional<double> secondsIn(std::string_view unit) {
  static const Units units{{"s", 1},      {"sec", 1},           {"second", 1},
                           {"ms", 1e-3},  {"msec", 1e-3},       {"millisecond", 1e-3},
                           {"us", 1e-6},  {"usec", 1e-6},       {"microsecond", 1e-6},
                           {"ns", 1e-9},  {"nanosecond", 1e-9}, {"min", 60},
                           {"minute", 60}};
  return look(units, unit);
}

}  // namespace sonoskin
