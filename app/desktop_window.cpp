#include "app/desktop_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/theme.h"
#include "core/base/error.h"

namespace sonoskin {
namespace {

constexpr int kSettlingFrames = 3;

// GLFW reports what went wrong through a function without state of ours: its last words are kept here.
std::string& lastGlfwError() {
  static std::string text;
  return text;
}

[[noreturn]] void giveUp(const std::string& what) {
  glfwTerminate();
  throw Error(fmt::format("The window cannot be opened for want of {} ({}); without one use 'sonoskin run' "
                          "or 'sonoskin render'.",
                          what, lastGlfwError().empty() ? "no reason given" : lastGlfwError()),
              Error::Kind::system);
}

}  // namespace

// Callbacks: every event asks for a frame. Those of mouse and keyboard wait in the queue for theirs.
struct DesktopWindow::Callbacks {
  static DesktopWindow& self(GLFWwindow* window) {
    return *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(window));
  }
  template <class... Args>
  static void wake(GLFWwindow* window, Args...) {
    self(window).requestFrames();
  }
  static void drop(GLFWwindow* window, int count, const char** paths) {
    self(window).dropped_.assign(paths, paths + count);
    self(window).requestFrames();
  }
  static void scale(GLFWwindow* window, float x, float y) {
    self(window).wantedScale_ = std::max({x, y, 1.0f});
    self(window).requestFrames();
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
    self(window).add({.kind = Event::Kind::position, .at = kNowhere}, EventTimes::Kind::motion);
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

DesktopWindow::DesktopWindow(const std::string& title, glm::ivec2 size) {
  glfwSetErrorCallback([](int, const char* text) { lastGlfwError() = text; });
  if (!glfwInit()) giveUp("a display");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (!window_) giveUp("OpenGL 4.5");
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  glfwSetWindowSizeLimits(window_, 800, 600, GLFW_DONT_CARE, GLFW_DONT_CARE);
  Callbacks::install(window_);

  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;          // the layout is computed, there is nothing to remember
  ImGui_ImplGlfw_InitForOpenGL(window_, false);  // the queue takes the place of its callbacks
  ImGui_ImplOpenGL3_Init("#version 450");
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  scale_ = 0;
  wantedScale_ = std::max({x, y, 1.0f});
}

DesktopWindow::~DesktopWindow() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void DesktopWindow::requestFrames(int frames) { framesLeft_ = std::max(framesLeft_, frames); }

void DesktopWindow::settle() { queue_.rest(kSettlingFrames); }

// One display's clock may be a little off another's: time never goes back.
void DesktopWindow::addNow(Event event) {
  event.time = lastEvent_;
  queue_.add(std::move(event));
  requestFrames();
}

void DesktopWindow::add(Event event, EventTimes::Kind kind) {
  lastEvent_ = std::max(lastEvent_, times_.next(kind, glfwGetTime()));
  addNow(std::move(event));
}

bool DesktopWindow::waitForFrame(double timeout) {
  if (eventsWait()) return true;
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

void DesktopWindow::applyContentScale() {
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ui::loadFonts(wantedScale_);
  ui::applyTheme(wantedScale_);
  ImGui_ImplOpenGL3_CreateFontsTexture();
  scale_ = wantedScale_;  // tried again in the next frame where one of these failed
}

std::optional<Event> DesktopWindow::beginFrame() {
  if (scale_ != wantedScale_) applyContentScale();
  const std::optional<Event> event = queue_.take();
  if (event) requestFrames();
  if (framesLeft_ > 0) --framesLeft_;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  feed_.feed(event, polled_, ImGui::GetIO());
  ImGui::NewFrame();
  return event;
}

void DesktopWindow::endFrame() {
  if (eventsWait()) return ImGui::EndFrame();
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

bool DesktopWindow::closeRequested() const { return glfwWindowShouldClose(window_); }
void DesktopWindow::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void DesktopWindow::keepOpen() { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
void DesktopWindow::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

std::vector<std::filesystem::path> DesktopWindow::takeDroppedFiles() { return std::exchange(dropped_, {}); }

glm::ivec2 DesktopWindow::size() const {
  glm::ivec2 s;
  glfwGetWindowSize(window_, &s.x, &s.y);
  return s;
}

glm::ivec2 DesktopWindow::framebufferSize() const {
  glm::ivec2 s;
  glfwGetFramebufferSize(window_, &s.x, &s.y);
  return s;
}

}  // namespace sonoskin
