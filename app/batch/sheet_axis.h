#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/parameters.h"

namespace sonoskin {

// SheetAxis: a parameter and the values that a contact sheet shows it at.
//   parameter  "classification.beta"
//   symbol     for people: "β", "v_iso", else "Low pass"
//   values     as setParameter() reads them
//   current    which of them the parameters have, if one
struct SheetAxis {
  std::string parameter, symbol;
  std::vector<std::string> values;
  std::optional<std::size_t> current{};
};

// kMostValues: of an axis.
inline constexpr std::size_t kMostValues = 20;

// sheetAxis: of "beta=0.5,1,2"; names as findParameter() knows them.
//   errors  Error (usage): no values, too many, the same twice, one out of range, a parameter of several numbers
//          or of the scan itself
SheetAxis sheetAxis(const Parameters& parameters, const std::string& text);

// sheetWord: the text that sheetAxis() reads.
std::string sheetWord(const SheetAxis& axis);

// cellText: what a cell of the sheet has: "β 0.5   v_iso 0.31".
std::string cellText(const std::vector<SheetAxis>& axes, const std::vector<std::size_t>& values);

// withValues: the parameters of a cell.
Parameters withValues(Parameters parameters, const std::vector<SheetAxis>& axes,
                      const std::vector<std::size_t>& values);

}  // namespace sonoskin
