#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

struct GLFWwindow;

namespace sonoskin {

// KeyPress: a key of GLFW that went down, with what was held.
struct KeyPress {
  int key = 0;
  bool control = false, shift = false, alt = false;
};

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

  void beginFrame();
  void endFrame();  // draws the interface and shows it

  bool closeRequested() const;
  void close();
  void keepOpen();  // takes a request to close back
  void setTitle(const std::string& title);
  // takeDroppedFiles: what was dropped on the window since the last call.
  std::vector<std::filesystem::path> takeDroppedFiles();
  // takeKeys: the keys that went down since the last call. ImGui only sees which keys are down when a frame begins,
  // so that it misses one that is pressed and let go while a frame is drawn.
  std::vector<KeyPress> takeKeys();
  float contentScale() const { return scale_; }
  glm::ivec2 size() const;             // in the units of mouse positions
  glm::ivec2 framebufferSize() const;  // in pixels

 private:
  struct Callbacks;
  void applyContentScale();

  GLFWwindow* window_ = nullptr;
  float scale_ = 1, wantedScale_ = 1;
  int framesLeft_ = 3;
  std::vector<std::filesystem::path> dropped_;
  std::vector<KeyPress> keys_;
};

}  // namespace sonoskin
