#include "app/window/desktop_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include "core/base/error.h"
#include "render/gl/context.h"
#include "render/gl/framebuffer.h"

namespace sonoskin {
namespace {

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

// The size, or what of it the screen has room for: no window manager may be there to see to that.
glm::ivec2 fitting(glm::ivec2 size) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (!monitor) return size;
  glm::ivec2 place, room;
  glfwGetMonitorWorkarea(monitor, &place.x, &place.y, &room.x, &room.y);
  return glm::any(glm::lessThanEqual(room, glm::ivec2(0))) ? size : glm::min(size, room);
}

}  // namespace

DesktopWindow::DesktopWindow(const std::string& title, glm::ivec2 size, const WindowLook& look)
    : look_(look) {
  glfwSetErrorCallback([](int, const char* text) { lastGlfwError() = text; });
  if (!glfwInit()) giveUp("a display");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  const glm::ivec2 first = fitting(size);
  window_ = glfwCreateWindow(first.x, first.y, title.c_str(), nullptr, nullptr);
  if (!window_) giveUp("OpenGL 4.5");
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowSizeLimits(window_, 800, 600, GLFW_DONT_CARE, GLFW_DONT_CARE);
  events_.attach(window_);
  const glm::ivec2 room = fitting(glm::ivec2(scale() * glm::vec2(size)));  // its scale is known only now
  glfwSetWindowSize(window_, room.x, room.y);

  gl::loadGl(glfwGetProcAddress);
  interface_.emplace();
  ImGui_ImplGlfw_InitForOpenGL(window_, false);  // the queue takes the place of its callbacks
}

DesktopWindow::~DesktopWindow() {
  ImGui_ImplGlfw_Shutdown();
  interface_.reset();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

float DesktopWindow::screenScale() const {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  return scaleOfScreen(events_.contentScale(), mode ? mode->width : 0);
}

float DesktopWindow::scale() const { return look_.scale > 0 ? float(look_.scale) : screenScale(); }

std::optional<Event> DesktopWindow::beginFrame(const ui::KeySteering& steering) {
  if (interface_->dress({look_.appearance, double(scale())})) events_.requestFrames(3);
  const std::optional<Event> event = events_.take();
  ImGui_ImplGlfw_NewFrame();
  interface_->beginFrame(event, events_.knownUntil(), steering);
  events_.hasBegun();
  return event;
}

void DesktopWindow::endFrame() {
  const bool seen = !eventsWait();
  const ImVec4& ground = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  if (seen) gl::Target(0, {0, 0}, framebufferSize()).clear({ground.x, ground.y, ground.z, 1});
  interface_->endFrame(seen);
  if (seen) glfwSwapBuffers(window_);
}

void DesktopWindow::setTitle(const char* title) { glfwSetWindowTitle(window_, title); }
bool DesktopWindow::closeRequested() const { return glfwWindowShouldClose(window_); }
void DesktopWindow::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void DesktopWindow::keepOpen() { glfwSetWindowShouldClose(window_, GLFW_FALSE); }

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
