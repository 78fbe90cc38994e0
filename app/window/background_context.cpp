#include "app/window/background_context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "core/base/error.h"

namespace sonoskin {
// Turn: the context while it is somebody's.
class BackgroundContext::Turn final : public gl::Context {
 public:
  explicit Turn(BackgroundContext& background) : background_(background) {}
  ~Turn() override { release(); }
  void makeCurrent() override {
    if (held_) return;
    background_.mutex_.lock();
    held_ = true;
    glfwMakeContextCurrent(background_.window_);
  }
  void release() override {
    if (!held_) return;
    glfwMakeContextCurrent(nullptr);
    held_ = false;
    background_.mutex_.unlock();
  }

 private:
  BackgroundContext& background_;
  bool held_ = false;
};

// By EGL where that is there: Mesa's software renderer draws one picture at a time for all contexts of GLX. The window's other
// hints, which came first, hold on.
BackgroundContext::BackgroundContext() {
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  for (const int maker : {GLFW_EGL_CONTEXT_API, GLFW_NATIVE_CONTEXT_API}) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, maker);
    if (!window_) window_ = glfwCreateWindow(16, 16, "Sonoskin", nullptr, nullptr);
  }
  glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
  if (!window_)
    throw Error(
        "The display gives no second OpenGL context to draw the picture with; 'sonoskin render' can draw it.",
        Error::Kind::system);
}

BackgroundContext::~BackgroundContext() { glfwDestroyWindow(window_); }

std::shared_ptr<gl::Context> BackgroundContext::share() { return std::make_shared<Turn>(*this); }

}  // namespace sonoskin
