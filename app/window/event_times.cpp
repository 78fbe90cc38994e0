#include "app/window/event_times.h"

#include <X11/Xlib.h>
#include <dlfcn.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace sonoskin {
namespace {

// Xlib hands every waiting event to a function that may choose one. This one chooses none, it only reads.
int note(Display*, XEvent* event, XPointer list) {
  auto& events = *reinterpret_cast<std::vector<XEvent>*>(list);
  switch (event->type) {
    case KeyPress:
    case KeyRelease:
    case ButtonPress:
    case ButtonRelease:
    case MotionNotify:
    case EnterNotify:
      events.push_back(*event);
      break;
    default:
      break;
  }
  return False;
}

struct ServerEvent {
  std::optional<EventTimes::Kind> kind;  // none: GLFW does not report it
  Time time;
};

ServerEvent read(const XEvent& event) {
  using Kind = EventTimes::Kind;
  if (event.type == KeyPress || event.type == KeyRelease) return {Kind::key, event.xkey.time};
  if (event.type == MotionNotify || event.type == EnterNotify) return {Kind::motion, event.xmotion.time};
  const bool wheel = event.xbutton.button >= Button4 && event.xbutton.button <= 7;  // as X has it
  if (!wheel) return {Kind::button, event.xbutton.time};
  if (event.type == ButtonPress) return {Kind::wheel, event.xbutton.time};
  return {std::nullopt, event.xbutton.time};
}

// The X display of GLFW; none where GLFW was built for another kind, and lacks the function.
Display* xDisplay() {
  using GetDisplay = Display* (*)();
  static const auto get = reinterpret_cast<GetDisplay>(::dlsym(RTLD_DEFAULT, "glfwGetX11Display"));
  return get ? get() : nullptr;
}

}  // namespace

void EventTimes::look(double now) {
  Display* display = xDisplay();
  if (!display) return;
  std::vector<XEvent> events;
  XEvent none;
  ::XCheckIfEvent(display, &none, note, reinterpret_cast<XPointer>(&events));
  for (const XEvent& event : events) {
    const ServerEvent noted = read(event);
    const double server = serverSeconds(std::uint32_t(noted.time));
    if (noted.kind) waiting_.push_back({*noted.kind, server});
  }
  // Nothing is known before it happened: the least delay seen so far is taken for none.
  if (!waiting_.empty()) ahead_ = std::min(ahead_, now - waiting_.back().server);
}

double EventTimes::serverSeconds(std::uint32_t milliseconds) {
  server_ += known_ ? std::int32_t(milliseconds - last_) : std::int64_t(milliseconds);
  last_ = milliseconds;
  known_ = true;
  return 1e-3 * double(server_);
}

double EventTimes::next(Kind kind, double now) {
  while (!waiting_.empty()) {
    const TimedEvent first = waiting_.front();
    waiting_.pop_front();  // GLFW does not report all that X sends
    if (first.kind == kind) return std::min(now, first.server + ahead_);
  }
  return now;
}

}  // namespace sonoskin
