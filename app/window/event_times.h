#pragma once

#include <cstdint>
#include <deque>
#include <limits>

namespace sonoskin {

// EventTimes: when the events that wait at the display happened. GLFW tells neither that nor anything about an event
// before it is polled, which is after the frame that was being drawn; an X server has noted it.
//   threads  GLFW's
class EventTimes {
 public:
  enum class Kind { key, button, wheel, motion };
  // look: notes the times of what waits, before it is polled.
  //   now  seconds
  void look(double now);
  // next: the time of the next event of a kind that GLFW reports, in its order; `now` where the display did not say.
  double next(Kind kind, double now);
  // forget: whatever was noted and not reported is over.
  void forget() { waiting_.clear(); }

 private:
  struct TimedEvent {
    Kind kind;
    double server;  // seconds of the display's own clock
  };
  double serverSeconds(std::uint32_t milliseconds);

  std::deque<TimedEvent> waiting_;
  std::uint32_t last_ = 0;
  std::int64_t server_ = 0;                            // the same, without its turns of 50 days
  double ahead_ = std::numeric_limits<double>::max();  // of our clock before the display's
  bool known_ = false;
};

}  // namespace sonoskin
