#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/event_feed.h"
#include "app/event_queue.h"
#include "app/event_times.h"

struct GLFWwindow;

namespace sonoskin {

// DesktopWindow: one window of the desktop with an OpenGL 4.5 context, which it makes current, and Dear ImGui
// on top. It draws only when asked: a still window costs no time.
//   errors   Error (system): no display, or no OpenGL 4.5
//   threads  main thread only
class DesktopWindow {
 public:
  DesktopWindow(const std::string& title, glm::ivec2 size);
  ~DesktopWindow();
  DesktopWindow(const DesktopWindow&) = delete;
  DesktopWindow& operator=(const DesktopWindow&) = delete;

  // waitForFrame: sleeps until an event comes or `timeout` seconds are over; true when a frame should be
  // drawn, as after any event (and for two frames more: the interface answers in the frame after the event).
  bool waitForFrame(double timeout);
  void requestFrames(int frames = 3);

  // beginFrame: a frame of the interface, with the next event that waits.
  //   output  that event
  std::optional<Event> beginFrame();
  // eventsWait: whether more have happened than frames have seen. Such frames need not be shown: they are there for what
  // happened during an earlier one, and must not cost as much.
  bool eventsWait() const { return !queue_.empty(); }
  // settle: what is opened in this frame is ready for keys before it gets the next.
  void settle();
  void endFrame();  // draws the interface and shows it; where events wait, it only ends the frame

  bool closeRequested() const;
  void close();
  void keepOpen();  // takes a request to close back
  void setTitle(const std::string& title);
  // takeDroppedFiles: what was dropped on the window since the last call.
  std::vector<std::filesystem::path> takeDroppedFiles();
  float contentScale() const { return scale_; }
  glm::ivec2 size() const;             // in the units of mouse positions
  glm::ivec2 framebufferSize() const;  // in pixels

 private:
  struct Callbacks;
  void applyContentScale();
  void add(Event event, EventTimes::Kind kind);
  void addNow(Event event);

  GLFWwindow* window_ = nullptr;
  float scale_ = 1, wantedScale_ = 1;
  int framesLeft_ = 3;
  std::vector<std::filesystem::path> dropped_;
  EventTimes times_;
  EventQueue queue_;
  EventFeed feed_;
  double lastEvent_ = 0,
         polled_ = 0;  // seconds of GLFW's clock: of the last event, until which all are known
};

}  // namespace sonoskin
