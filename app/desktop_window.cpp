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

// Callbacks: every event asks for a frame. ImGui's own callbacks are installed later and call these first.
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
  static void key(GLFWwindow* window, int key, int, int action, int mods) {
    if (action == GLFW_PRESS) {
      self(window).keys_.push_back(
          {key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0});
    }
    self(window).requestFrames();
  }
  static void install(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, wake<double, double>);
    glfwSetMouseButtonCallback(window, wake<int, int, int>);
    glfwSetScrollCallback(window, wake<double, double>);
    glfwSetKeyCallback(window, key);
    glfwSetCharCallback(window, wake<unsigned int>);
    glfwSetWindowFocusCallback(window, wake<int>);
    glfwSetCursorEnterCallback(window, wake<int>);
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
  ImGui::GetIO().IniFilename = nullptr;  // the layout is computed, there is nothing to remember
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
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

bool DesktopWindow::waitForFrame(double timeout) {
  if (framesLeft_ > 0) {
    glfwPollEvents();
  } else {
    glfwWaitEventsTimeout(timeout);
  }
  return framesLeft_ > 0;
}

void DesktopWindow::applyContentScale() {
  scale_ = wantedScale_;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ui::loadFonts(scale_);
  ui::applyTheme(scale_);
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void DesktopWindow::beginFrame() {
  if (scale_ != wantedScale_) applyContentScale();
  if (framesLeft_ > 0) --framesLeft_;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void DesktopWindow::endFrame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

bool DesktopWindow::closeRequested() const { return glfwWindowShouldClose(window_); }
void DesktopWindow::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void DesktopWindow::keepOpen() { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
void DesktopWindow::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

std::vector<std::filesystem::path> DesktopWindow::takeDroppedFiles() { return std::exchange(dropped_, {}); }

std::vector<KeyPress> DesktopWindow::takeKeys() { return std::exchange(keys_, {}); }

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
