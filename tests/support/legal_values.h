#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/pipeline/parameters.h"
#include "tests/support/pairwise.h"

namespace sonoskin::test {

// Choice: a thing with a few values: a switch, or one of several names.
struct Choice {
  std::string name;
  int count = 2;
  std::function<void(int)> choose;
};

// choicesOf: every switch and every choice of some parameters' groups; they act on `parameters`, which must stay.
inline std::vector<Choice> choicesOf(Parameters& parameters,
                                     const std::function<bool(const std::string& group)>& wanted) {
  std::vector<Choice> choices;
  forEachField(
      [&](const Group& group, const Field& field, auto& member, auto...) {
        using T = std::remove_reference_t<decltype(member)>;
        if (!wanted(std::string(group.name))) return;
        const std::string name = std::string(group.name) + "." + std::string(field.name);
        if constexpr (std::is_same_v<T, bool>)
          choices.push_back({name, 2, [&member](int value) { member = value == 1; }});
        else if constexpr (NamedEnum<T>)
          choices.push_back({name, int(enumNames(T{}).size()), [&member](int value) { member = T(value); }});
      },
      parameters);
  return choices;
}

// chooseInPairs: calls f(what was chosen) with every pair of values of any two choices.
template <class F>
void chooseInPairs(const std::vector<Choice>& choices, F&& f) {
  std::vector<int> counts;
  for (const Choice& c : choices) counts.push_back(c.count);
  for (const std::vector<int>& row : pairwise(counts)) {
    std::string chosen;
    for (std::size_t c = 0; c < choices.size(); ++c) {
      choices[c].choose(row[c]);
      chosen += choices[c].name + "=" + std::to_string(row[c]) + " ";
    }
    f(chosen);
  }
}

// atEnds: calls f(end) with a number, or the three of a place, at the least and the greatest that is allowed.
template <class T, class R, class F>
void atEnds(T& member, const Range<R>& range, F&& f) {
  const T before = member;
  for (const bool low : {true, false}) {
    const R end = low ? range.min : range.max;
    if constexpr (std::is_arithmetic_v<T>)
      member = end;
    else
      member.fill(end);
    f(low ? " least" : " greatest");
  }
  member = before;
}
template <class R, class F>
void atEnds(Places&, const Range<R>&, F&&) {}

// forEachEnd: calls f(name, parameters) with one number after the other at the ends of its range.
template <class F>
void forEachEnd(const Parameters& usual, F&& f) {
  Parameters p = usual;
  forEachField(
      [&](const Group& group, const Field& field, auto& member, const auto&... range) {
        const std::string name = std::string(group.name) + "." + std::string(field.name);
        (atEnds(member, range, [&](const char* end) { f(name + end, p); }), ...);
      },
      p);
}

}  // namespace sonoskin::test
