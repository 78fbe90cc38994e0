#include "app/widgets/number_text.h"

#include <fmt/format.h>

#include <cmath>

#include "app/texts/texts.h"

namespace sonoskin::ui {

std::string grouped(std::size_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += tr(",");
    text += digits[i];
  }
  return text;
}

std::string millimetres(double value) {
  return fmt::format("{:.{}f}", value, std::abs(value) < 1 ? 3 : std::abs(value) < 10 ? 2 : 1);
}

}  // namespace sonoskin::ui
