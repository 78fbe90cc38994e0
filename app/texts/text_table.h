#pragma once

#include <array>
#include <span>

namespace sonoskin {

// Text: one text of the window in all languages; UTF-8, with the same places for numbers in the same order.
struct Text {
  const char *english, *german, *french;
};

// The tables, one a subject and file.
std::span<const Text> commonTexts();
std::span<const Text> commandTexts();
std::span<const Text> stepTexts();
std::span<const Text> panelTexts();
std::span<const Text> widgetTexts();
std::span<const Text> helpTexts();
std::span<const Text> fileTexts();
std::span<const Text> parameterNames();
std::span<const Text> choiceTexts();
std::span<const Text> foundHelps();
std::span<const Text> surfaceHelps();
std::span<const Text> skinHelps();
std::span<const Text> scanHelps();
std::span<const Text> useTexts();
std::span<const Text> messageTexts();
std::span<const Text> outputTexts();

// textTables: all that tr() knows.
std::array<std::span<const Text>, 16> textTables();

}  // namespace sonoskin
