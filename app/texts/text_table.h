#pragma once

#include <span>

namespace sonoskin {

// Text: one text of the window in all languages; UTF-8, with the same places for numbers.
struct Text {
  const char *english, *german, *french;
};

// textTable: all that tr() knows.
std::span<const Text> textTable();

}  // namespace sonoskin
