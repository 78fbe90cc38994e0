#include <dlfcn.h>
#include <glad/gl.h>

#include <array>

#include "core/base/error.h"
#include "render/gl/offscreen.h"

namespace sonoskin::gl {
namespace {

// The part of GL/osmesa.h that is needed (that header would pull in GL/gl.h beside our loader).
using OsMesaHandle = struct OsMesaContextRecord*;
constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34, kMajorVersion = 0x36,
              kMinorVersion = 0x37;

struct Library {
  OsMesaHandle (*create)(const int* attributes, OsMesaHandle share);
  GLboolean (*makeCurrent)(OsMesaHandle, void* buffer, GLenum type, GLsizei width, GLsizei height);
  void (*destroy)(OsMesaHandle);
  Function (*getProcAddress)(const char* name);
};

template <class F>
void find(void* library, const char* name, F& function) {
  function = reinterpret_cast<F>(dlsym(library, name));
  if (!function) throw Error(fmt::format("libOSMesa.so.8 lacks {}", name), Error::Kind::system);
}

// Loaded once; it stays, since the driver below it does not survive being unloaded.
const Library& osMesa() {
  static const Library library = [] {
    void* handle = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw Error("libOSMesa.so.8 was not found; install libosmesa6", Error::Kind::system);
    Library l;
    find(handle, "OSMesaCreateContextAttribs", l.create);
    find(handle, "OSMesaMakeCurrent", l.makeCurrent);
    find(handle, "OSMesaDestroyContext", l.destroy);
    find(handle, "OSMesaGetProcAddress", l.getProcAddress);
    return l;
  }();
  return library;
}

void releaseOsMesa() { osMesa().makeCurrent(nullptr, nullptr, 0, 0, 0); }

class OsMesaContext final : public Context {
 public:
  OsMesaContext() {
    constexpr std::array<int, 11> attributes{
        kFormat, GL_RGBA, kDepthBits, 24, kProfile, kCoreProfile, kMajorVersion, 4, kMinorVersion, 5, 0};
    context_ = osMesa().create(attributes.data(), nullptr);
    if (!context_) throw Error("OSMesa gives no OpenGL 4.5 context", Error::Kind::system);
  }
  ~OsMesaContext() override {
    forget(this);
    osMesa().destroy(context_);
  }
  void release() override { forget(this); }
  void makeCurrent() override {
    if (switchTo(this, releaseOsMesa)) return;
    if (!osMesa().makeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1))
      throw Error("the OSMesa context cannot be used on this thread", Error::Kind::system);
    loadGl(osMesa().getProcAddress);
  }

 private:
  OsMesaHandle context_;
  std::array<unsigned char, 4> pixel_{};  // the default framebuffer, which nothing draws to
};

}  // namespace

std::unique_ptr<Context> makeOsMesaContext() { return std::make_unique<OsMesaContext>(); }

}  // namespace sonoskin::gl
