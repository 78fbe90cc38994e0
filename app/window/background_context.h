#pragma once

#include <functional>
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

  // use: draws with the context, on the thread that calls; one at a time, others wait. All GL objects of it must be gone
  // afterwards.
  void use(const std::function<void()>& draw);
  // share: for long work on one thread that draws now and then: from makeCurrent() to release() it is as within use(). It must
  // not outlive the context.
  std::shared_ptr<gl::Context> share();

 private:
  class Turn;
  GLFWwindow* window_ = nullptr;  // never shown
  std::mutex mutex_;              // held by whoever draws
};

}  // namespace sonoskin
