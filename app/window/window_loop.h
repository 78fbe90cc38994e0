#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/window/application.h"
#include "app/window/background_context.h"
#include "app/window/desktop_window.h"
#include "app/workspace/settings.h"

namespace sonoskin {

// WindowLoop: the application in a window of the desktop. frame() is one turn of its loop.
//   errors   see DesktopWindow
//   threads  main thread only
class WindowLoop {
 public:
  WindowLoop(const std::optional<std::filesystem::path>& file, const Parameters& parameters);
  ~WindowLoop();  // remembers the window's size

  // frame: waits for something to do, does it, draws; false when the window was closed and all is saved.
  bool frame();

  // For tests: what is in it, and a frame even though nothing happened.
  Application& application() { return application_; }
  const Application& application() const { return application_; }
  void requestFrame() { window_.requestFrames(1); }
  bool eventsWait() const { return window_.eventsWait(); }
  // atFrame: called where a frame begins that will be shown.
  std::function<void()> atFrame;

 private:
  void draw();
  void showModified();
  void answerClosing();

  Settings settings_;  // as they were remembered
  DesktopWindow window_;
  std::optional<BackgroundContext> background_;  // made when first needed
  Application application_;
  bool titleModified_ = false;
};

}  // namespace sonoskin
