#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/window/interface.h"
#include "app/window/window_events.h"

struct GLFWwindow;

namespace sonoskin {

// DesktopWindow: one window of the desktop with an OpenGL 4.5 context, which it makes current, and Dear ImGui
// on top. It draws only when asked: a still window costs no time.
//   errors   Error (system): no display, or no OpenGL 4.5
//   threads  main thread only
class DesktopWindow {
 public:
  //   size  at scale 1
  DesktopWindow(const std::string& title, glm::ivec2 size, const WindowLook& look);
  ~DesktopWindow();
  DesktopWindow(const DesktopWindow&) = delete;
  DesktopWindow& operator=(const DesktopWindow&) = delete;

  // waitForFrame: sleeps until an event comes or `timeout` seconds are over; true when a frame should be
  // drawn, as after any event (and for two frames more: the interface answers in the frame after the event).
  bool waitForFrame(double timeout) { return events_.waitForFrame(timeout); }
  void requestFrames(int frames = 3) { events_.requestFrames(frames); }

  // beginFrame: a frame of the interface, with the next event that waits.
  //   output  that event
  std::optional<Event> beginFrame(const ui::KeySteering& steering = {});
  // eventsWait: whether more have happened than frames have seen. Such frames need not be shown: they are there for what
  // happened during an earlier one, and must not cost as much.
  bool eventsWait() const { return events_.wait(); }
  // settle: what is opened in this frame is ready for keys before it gets the next.
  void settle() { events_.settle(); }
  void endFrame();  // draws the interface and shows it; where events wait, it only ends the frame

  void setTitle(const char* title);
  bool closeRequested() const;
  void close();
  void keepOpen();  // takes a request to close back
  // takeDroppedFiles: what was dropped on the window since the last call.
  std::vector<std::filesystem::path> takeDroppedFiles() { return events_.takeDroppedFiles(); }
  // setLook: from the next frame on.
  void setLook(const WindowLook& look) { look_ = look; }
  float scale() const;                 // in use
  float screenScale() const;           // see scaleOfScreen
  glm::ivec2 size() const;             // in the units of mouse positions
  glm::ivec2 framebufferSize() const;  // in pixels

 private:
  GLFWwindow* window_ = nullptr;
  WindowLook look_;
  WindowEvents events_;
  std::optional<Interface> interface_;  // once there is a context
};

}  // namespace sonoskin
