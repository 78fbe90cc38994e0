#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

#include "core/base/error.h"
#include "render/gl/offscreen.h"

namespace sonoskin::gl {
namespace {

// A display without a window system: Mesa's surfaceless platform, or a graphics card of a driver that has
// only devices. It is never terminated: that would end every other context of the process on it.
EGLDisplay openDisplay() {
  const EGLDisplay mesa = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (mesa != EGL_NO_DISPLAY && eglInitialize(mesa, nullptr, nullptr)) return mesa;
  const auto queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 8> devices{};
  EGLint count = 0;
  if (queryDevices && queryDevices(EGLint(devices.size()), devices.data(), &count))
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
      const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
      if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    }
  throw Error("no EGL display was found; install libegl-mesa0, or try --gl osmesa", Error::Kind::system);
}

void releaseEgl() {
  eglBindAPI(EGL_OPENGL_API);
  if (const EGLDisplay display = eglGetCurrentDisplay(); display != EGL_NO_DISPLAY)
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

Function findFunction(const char* name) { return eglGetProcAddress(name); }

class EglContext final : public Context {
 public:
  EglContext() : display_(openDisplay()) {
    constexpr std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               4,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               5,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_CONTEXT_OPENGL_DEBUG,
                                               EGL_TRUE,
                                               EGL_NONE};
    eglBindAPI(EGL_OPENGL_API);
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT)
      throw Error("EGL gives no OpenGL 4.5 context; install libgl1-mesa-dri, or try --gl osmesa",
                  Error::Kind::system);
  }
  ~EglContext() override {
    forget(this);
    eglDestroyContext(display_, context_);
  }
  void release() override { forget(this); }
  void makeCurrent() override {
    if (switchTo(this, releaseEgl)) return;
    eglBindAPI(EGL_OPENGL_API);
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw Error("the EGL context cannot be used on this thread", Error::Kind::system);
    loadGl(findFunction);
  }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

}  // namespace

std::unique_ptr<Context> makeEglContext() { return std::make_unique<EglContext>(); }

}  // namespace sonoskin::gl
