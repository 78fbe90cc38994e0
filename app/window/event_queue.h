#pragma once

#include <cfloat>
#include <deque>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sonoskin {

// Event: what a person did with the mouse or the keyboard.
//   time  seconds of any clock that all events share
//   at    position: in the window; wheel: notches to the right and away from the person
//   code  button or key of GLFW, with what was held when it moved
//   down  button, key: whether it went down; focus: whether the window has it now
struct Event {
  enum class Kind { position, button, wheel, key, text, focus };
  Kind kind = Kind::position;
  double time = 0;
  glm::vec2 at{0};
  int code = 0;
  bool down = false;
  bool control = false, shift = false, alt = false;
  std::u32string text{};
  std::vector<glm::vec2>
      through{};  // position: where the mouse was on its way, in positions that are one now
};

// kNowhere: the position of a mouse that is outside the window.
inline constexpr glm::vec2 kNowhere{-FLT_MAX, -FLT_MAX};

// EventQueue: what happened while a frame was drawn, for the frames that follow it. An interface that asks how things
// are once a frame misses a button that went down and up in between, and takes a press to be where the mouse is by now.
// So each frame gets one event; only positions, turns of the wheel and characters that follow each other are one.
class EventQueue {
 public:
  void add(Event event);
  // rest: the next `frames` frames get nothing: what has just opened takes some to be ready for keys.
  void rest(int frames) { resting_ = frames; }
  // take: what the next frame gets, if anything.
  std::optional<Event> take();
  bool empty() const { return events_.empty(); }

 private:
  std::deque<Event> events_;
  int resting_ = 0;
};

}  // namespace sonoskin
