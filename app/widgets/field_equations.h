#pragma once

#include <string>
#include <string_view>

namespace sonoskin::ui {

// equationOf: where a parameter stands in what is solved, for a tooltip: a line with its symbol, and perhaps one that says what it does; empty where there is
// no equation of its own. Greek and mathematical letters, indices after an underscore.
//   id      "group.field"
//   source  assets/docs/theory/classification.md and reconstruction.md
std::string equationOf(std::string_view id);

}  // namespace sonoskin::ui
