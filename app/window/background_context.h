#pragma once

#include <memory>
#include <mutex>

#include "render/gl/context.h"

struct GLFWwindow;

namespace sonoskin {

// BackgroundContext: a second OpenGL context, of the window's own driver, in which pictures for files are drawn while the
// window goes on. It shares nothing with the first.
//   errors   Error (system): the display gives no second one
//   threads  made and destroyed on the main thread, when nothing is being drawn
class BackgroundContext {
 public:
  BackgroundContext();
  ~BackgroundContext();
  BackgroundContext(const BackgroundContext&) = delete;
  BackgroundContext& operator=(const BackgroundContext&) = delete;

  // share: it is somebody's from makeCurrent() to release(), others wait; all GL objects of it must be gone then. What is shared
  // must not outlive the context.
  std::shared_ptr<gl::Context> share();

 private:
  class Turn;
  GLFWwindow* window_ = nullptr;  // never shown
  std::mutex mutex_;              // held by whoever draws
};

}  // namespace sonoskin
