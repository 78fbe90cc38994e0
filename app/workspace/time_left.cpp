#include "app/workspace/time_left.h"

#include <fmt/format.h>

#include <cmath>

#include "app/texts/texts.h"

namespace sonoskin {
namespace {

constexpr double kLeastSeconds = 0.8, kLeastFraction = 0.03;  // before it is more than a guess

}  // namespace

// A fraction that falls is another job's.
std::optional<double> TimeLeft::of(const Activity& activity, double now) {
  if (!activity.busy || !busy_ || activity.fraction < fraction_) begun_ = now;
  busy_ = activity.busy;
  fraction_ = activity.fraction;
  const double passed = now - begun_;
  if (!busy_ || passed < kLeastSeconds || fraction_ < kLeastFraction) return {};
  return passed * (1 - fraction_) / fraction_;
}

std::string timeLeftText(const std::optional<double>& seconds) {
  if (!seconds || *seconds < 0.5) return {};
  if (*seconds > 90) return trf("{:.0f} min left", std::ceil(*seconds / 60));
  return trf("{:.0f} s left", std::ceil(*seconds));
}

}  // namespace sonoskin
