#include "app/window/window_events.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace sonoskin {
namespace {

constexpr int kSettlingFrames = 3;  // the interface answers in the frames after an event

}  // namespace

struct WindowEvents::Callbacks {
  static WindowEvents& self(GLFWwindow* window) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
  }
  template <class... Args>
  static void wake(GLFWwindow* window, Args...) {
    self(window).requestFrames(kSettlingFrames);
  }
  static void drop(GLFWwindow* window, int count, const char** paths) {
    auto& dropped = self(window).dropped_;
    dropped.insert(dropped.end(), paths, paths + count);
    self(window).requestFrames(kSettlingFrames);
  }
  static void scale(GLFWwindow* window, float x, float y) {
    self(window).contentScale_ = std::max({x, y, 1.0f});
    self(window).requestFrames(kSettlingFrames);
  }
  static void position(GLFWwindow* window, double x, double y) {
    self(window).add({.kind = Event::Kind::position, .at = {x, y}}, EventTimes::Kind::motion);
  }
  static void enter(GLFWwindow* window, int entered) {
    // Where it is follows when it enters. While a button is held it belongs to the window wherever it is.
    bool isHeld = false;
    for (const int button : {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_RIGHT, GLFW_MOUSE_BUTTON_MIDDLE})
      isHeld = isHeld || glfwGetMouseButton(window, button) == GLFW_PRESS;
    if (entered || isHeld) return wake(window);
    self(window).addNow({.kind = Event::Kind::position, .at = kNowhere});
  }
  static void button(GLFWwindow* window, int button, int action, int mods) {
    self(window).add(held({.kind = Event::Kind::button, .code = button, .down = action == GLFW_PRESS}, mods),
                     EventTimes::Kind::button);
  }
  static void wheel(GLFWwindow* window, double right, double away) {
    self(window).add({.kind = Event::Kind::wheel, .at = {right, away}}, EventTimes::Kind::wheel);
  }
  static void key(GLFWwindow* window, int key, int, int action, int mods) {
    if (action == GLFW_REPEAT) return wake(window);  // ImGui has its own
    self(window).add(held({.kind = Event::Kind::key, .code = key, .down = action == GLFW_PRESS}, mods),
                     EventTimes::Kind::key);
  }
  static void text(GLFWwindow* window, unsigned int character) {
    self(window).addNow({.kind = Event::Kind::text, .text = {char32_t(character)}});
  }
  static void focus(GLFWwindow* window, int focused) {
    self(window).addNow({.kind = Event::Kind::focus, .down = focused != 0});
  }
  static Event held(Event event, int mods) {
    event.control = (mods & GLFW_MOD_CONTROL) != 0;
    event.shift = (mods & GLFW_MOD_SHIFT) != 0;
    event.alt = (mods & GLFW_MOD_ALT) != 0;
    return event;
  }
  static void install(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, position);
    glfwSetMouseButtonCallback(window, button);
    glfwSetScrollCallback(window, wheel);
    glfwSetKeyCallback(window, key);
    glfwSetCharCallback(window, text);
    glfwSetWindowFocusCallback(window, focus);
    glfwSetCursorEnterCallback(window, enter);
    glfwSetFramebufferSizeCallback(window, wake<int, int>);
    glfwSetWindowRefreshCallback(window, wake<>);
    glfwSetWindowCloseCallback(window, wake<>);
    glfwSetWindowIconifyCallback(window, wake<int>);
    glfwSetDropCallback(window, drop);
    glfwSetWindowContentScaleCallback(window, scale);
  }
};

void WindowEvents::attach(GLFWwindow* window) {
  glfwSetWindowUserPointer(window, this);
  Callbacks::install(window);
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  contentScale_ = std::max({x, y, 1.0f});
}

void WindowEvents::requestFrames(int frames) { framesLeft_ = std::max(framesLeft_, frames); }

void WindowEvents::settle() { queue_.rest(kSettlingFrames); }

// One display's clock may be a little off another's: time never goes back.
void WindowEvents::addNow(Event event) {
  event.time = lastEvent_;
  queue_.add(std::move(event));
  requestFrames(kSettlingFrames);
}

void WindowEvents::add(Event event, EventTimes::Kind kind) {
  lastEvent_ = std::max(lastEvent_, times_.next(kind, glfwGetTime()));
  addNow(std::move(event));
}

bool WindowEvents::waitForFrame(double timeout) {
  if (wait() && begun_) return true;
  begun_ = false;
  if (framesLeft_ > 0) {
    times_.look(glfwGetTime());
    glfwPollEvents();
    times_.forget();
  } else {
    glfwWaitEventsTimeout(timeout);
  }
  polled_ = glfwGetTime();
  return framesLeft_ > 0;
}

std::optional<Event> WindowEvents::take() {
  const std::optional<Event> event = queue_.take();
  if (event) requestFrames(kSettlingFrames);
  if (framesLeft_ > 0) --framesLeft_;
  return event;
}

std::vector<std::filesystem::path> WindowEvents::takeDroppedFiles() { return std::exchange(dropped_, {}); }

}  // namespace sonoskin
