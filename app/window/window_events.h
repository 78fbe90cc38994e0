#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/window/event_queue.h"
#include "app/window/event_times.h"

struct GLFWwindow;

namespace sonoskin {

// WindowEvents: what the display tells a window. Every event asks for frames; those of mouse and keyboard wait in a queue for
// theirs.
//   threads  main thread only
class WindowEvents {
 public:
  WindowEvents() = default;
  WindowEvents(const WindowEvents&) = delete;  // the window knows where it is
  WindowEvents& operator=(const WindowEvents&) = delete;

  void attach(GLFWwindow* window);

  // waitForFrame, requestFrames, settle, takeDroppedFiles: see DesktopWindow.
  bool waitForFrame(double timeout);
  void requestFrames(int frames);
  void settle();
  std::vector<std::filesystem::path> takeDroppedFiles();

  // take: what the frame that begins gets, if anything; hasBegun: it could begin. Where frames cannot, the display is looked at
  // between them, so that the window can be closed.
  std::optional<Event> take();
  void hasBegun() { begun_ = true; }
  bool wait() const { return !queue_.empty(); }
  // knownUntil: seconds of the events' clock, until which they are known.
  double knownUntil() const { return polled_; }
  float contentScale() const { return contentScale_; }

 private:
  struct Callbacks;
  void add(Event event, EventTimes::Kind kind);
  void addNow(Event event);

  EventTimes times_;
  EventQueue queue_;
  std::vector<std::filesystem::path> dropped_;
  float contentScale_ = 1;
  int framesLeft_ = 3;
  bool begun_ = true;
  double lastEvent_ = 0, polled_ = 0;  // seconds of GLFW's clock
};

}  // namespace sonoskin
