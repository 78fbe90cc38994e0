#pragma once

#include <memory>
#include <string>

namespace sonoskin::gl {

// Backend: where an off-screen context comes from.
enum class Backend {
  egl,    // EGL without a surface: a graphics card where there is one, else Mesa's software rasteriser
  osmesa  // Mesa's off-screen library, loaded when asked for
};

// Context: an OpenGL 4.5 core context without a window. All GL objects must be gone before it goes.
class Context {
 public:
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  virtual ~Context() = default;

  // makeCurrent: later GL calls of this thread go here. Cheap if it is current already.
  virtual void makeCurrent() = 0;
  // release: it is current on this thread no longer, and may become so on another.
  virtual void release() = 0;
};

// makeOffscreenContext: a context for pictures without a display; it is current afterwards.
//   errors  Error (system): no such library, or its driver does not reach OpenGL 4.5
std::unique_ptr<Context> makeOffscreenContext(Backend backend = Backend::egl);

using Function = void (*)();
using GetProcAddress = Function (*)(const char* name);

// loadGl: finds the OpenGL functions of the context that is current (a window's: pass glfwGetProcAddress) and
// starts counting its error messages.
//   errors  Error (system): the context does not reach OpenGL 4.5
void loadGl(GetProcAddress getProcAddress);

// glInfo: "renderer, OpenGL version" of the current context, for reports.
std::string glInfo();

// glErrorCount: OpenGL errors since the program began, in all contexts; 0 in a healthy program. lastGlError:
// the driver's words for the latest.
int glErrorCount();
std::string lastGlError();

// pollErrors: takes the errors that the current context keeps until it is asked. Those that the driver has not told as a
// message, which it need not, are counted too.
struct PolledErrors {
  bool any = false, outOfMemory = false;
};
PolledErrors pollErrors();

}  // namespace sonoskin::gl
