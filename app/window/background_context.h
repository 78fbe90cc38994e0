#pragma once

#include <functional>

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

  // use: draws with the context, on the thread that calls; one at a time. All GL objects of it must be gone afterwards.
  void use(const std::function<void()>& draw);

 private:
  GLFWwindow* window_ = nullptr;  // never shown
};

}  // namespace sonoskin
