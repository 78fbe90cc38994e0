#include "app/cli/finite.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/base/shown_text.h"

namespace sonoskin {
namespace {

// Empty where it is one: as CLI11 has it.
std::string whyNotFinite(std::string& text) {
  const std::string_view number = text.starts_with('+') ? std::string_view(text).substr(1) : text;
  double value = 0;
  const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (failure == std::errc() && end == number.data() + number.size() && std::isfinite(value)) return {};
  return fmt::format("\"{}\" is not a finite number", shownText(text));
}

}  // namespace

CLI::Validator finite() { return CLI::Validator(whyNotFinite, ""); }

}  // namespace sonoskin
