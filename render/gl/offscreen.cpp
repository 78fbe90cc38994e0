#include "render/gl/offscreen.h"

namespace sonoskin::gl {
namespace {

thread_local const Context* current = nullptr;
thread_local Release releaseCurrent = nullptr;

}  // namespace

bool switchTo(const Context* next, Release release) {
  if (current == next) return true;
  if (current && releaseCurrent != release) releaseCurrent();
  current = next;
  releaseCurrent = release;
  return false;
}

void forget(const Context* gone) {
  if (current != gone) return;
  releaseCurrent();
  current = nullptr;
}

}  // namespace sonoskin::gl
