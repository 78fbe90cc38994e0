#pragma once

#include <array>
#include <span>

namespace sonoskin {

// Text: one text of the window in all languages; UTF-8, with the same places for numbers.
struct Text {
  const char *english, *german, *french;
};

// The tables, one a subject and file.
std::span<const Text> commonTexts();

// textTables: all that tr() knows.
std::array<std::span<const Text>, 1> textTables();

}  // namespace sonoskin
