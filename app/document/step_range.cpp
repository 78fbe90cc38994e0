#include "app/document/step_range.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "core/base/error.h"

namespace sonoskin {
namespace {

std::optional<int> step(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && number >= 1 && number <= StepRange::kLastStep ? std::optional(number) : std::nullopt;
}

}  // namespace

StepRange stepRange(const std::string& text) {
  if (text == "all") return {1, StepRange::kLastStep};
  const std::size_t dash = text.find('-');
  const auto first = step(std::string_view(text).substr(0, dash));
  const auto last = dash == std::string::npos ? first : step(std::string_view(text).substr(dash + 1));
  if (!first || !last || *last < *first)
    throw Error(fmt::format("--time {} is no time step; give all, a number from 1, or two with a dash, such "
                            "as 2-5.",
                            text),
                Error::Kind::usage);
  return {*first, *last};
}

StepRange stepsWithin(StepRange range, int timeSteps) {
  if (range.last == StepRange::kLastStep) range.last = timeSteps;
  require(range.last <= timeSteps && range.first <= range.last,
          "The scan has {} time step{}; there are no steps {} to {}.", timeSteps, timeSteps == 1 ? "" : "s",
          range.first, range.last);
  return range;
}

}  // namespace sonoskin
