#pragma once

#include <optional>
#include <string>

#include "app/document/session.h"

namespace sonoskin {

// TimeLeft: how long the work at hand will take on, from how long what is done of it took. It says nothing at first, while
// that is a guess.
class TimeLeft {
 public:
  // of: call it once a frame.
  //   now     seconds of any clock
  //   output  seconds; empty where nothing goes on, or nothing can be said yet
  std::optional<double> of(const Activity& activity, double now);

 private:
  bool busy_ = false;
  double begun_ = 0, fraction_ = 0;
};

// timeLeftText: "3 s left", "2 min left"; empty for nothing. In the window's language.
std::string timeLeftText(const std::optional<double>& seconds);

}  // namespace sonoskin
