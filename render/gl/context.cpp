#include "render/gl/context.h"

#include <glad/gl.h>

#include <atomic>
#include <mutex>
#include <utility>

#include "core/base/error.h"
#include "render/gl/offscreen.h"

namespace sonoskin::gl {
namespace {

std::atomic<int> errorCount{0};
std::mutex lastErrorMutex;
std::string lastError;

void count(std::string words) {
  ++errorCount;
  const std::lock_guard lock(lastErrorMutex);
  lastError = std::move(words);
}

void GLAD_API_PTR onMessage(GLenum source, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text,
                            const void*) {
  // A shader that does not compile is told as an Error by Program.
  if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
  count(std::string(text, std::size_t(length)));
}

std::string text(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

}  // namespace

std::unique_ptr<Context> makeOffscreenContext(Backend backend) {
  auto context = backend == Backend::egl ? makeEglContext() : makeOsMesaContext();
  context->makeCurrent();
  return context;
}

void loadGl(GetProcAddress getProcAddress) {
  const int version = gladLoadGL(getProcAddress);
  if (version < GLAD_MAKE_VERSION(4, 5))
    throw Error("the display driver does not offer OpenGL 4.5; a newer driver, or --gl osmesa, will do",
                Error::Kind::system);
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(onMessage, nullptr);
}

std::string glInfo() { return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION); }

int glErrorCount() { return errorCount; }

std::string lastGlError() {
  const std::lock_guard lock(lastErrorMutex);
  return lastError;
}

PolledErrors pollErrors() {
  thread_local int seen = 0;  // messages up to the last look
  const bool told = errorCount > seen;
  PolledErrors errors;
  constexpr int kMost = 100;  // a lost context has no last one
  for (int i = 0; i < kMost; ++i) {
    const GLenum code = glGetError();
    if (code == GL_NO_ERROR) break;
    errors.any = true;
    errors.outOfMemory = errors.outOfMemory || code == GL_OUT_OF_MEMORY;
    if (!told) count(fmt::format("OpenGL error 0x{:04x}", code));
  }
  seen = errorCount;
  return errors;
}

}  // namespace sonoskin::gl
