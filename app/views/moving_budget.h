#pragma once

#include <algorithm>

namespace sonoskin::ui {

// MovingBudget: how long a picture of something that moves may take, so that the window shows kFrames of them a second: what
// else a frame takes is taken off.
class MovingBudget {
 public:
  static constexpr double kFrames = 18;

  // frame: notes the last frame of the window.
  //   whole    seconds
  //   picture  seconds of them that its picture took; 0 where it drew none
  void frame(double whole, double picture) {
    if (picture <= 0) return;
    const double beside = std::max(whole - picture, 0.0);
    beside_ += kFollow * (beside - beside_);
  }
  double seconds() const { return std::clamp(1 / kFrames - beside_, kLeast, kMost); }

 private:
  static constexpr double kLeast = 0.012, kMost = 0.045, kFollow = 0.25;
  double beside_ = 1 / kFrames - kMost;
};

}  // namespace sonoskin::ui
