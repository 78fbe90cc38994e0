#pragma once

#include <string>

namespace sonoskin::ui {

// A symbol of an equation: what follows an underscore is an index, smaller and lower: "v_iso".

// symbolWidth: of the symbol, pixels; 0 for none.
float symbolWidth(const std::string& symbol);
// drawSymbol: faint, as an item in the line.
void drawSymbol(const std::string& symbol);

}  // namespace sonoskin::ui
