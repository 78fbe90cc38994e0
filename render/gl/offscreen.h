#pragma once

#include <memory>

#include "render/gl/context.h"

namespace sonoskin::gl {

// The two makers behind makeOffscreenContext; the context is not current yet.
std::unique_ptr<Context> makeEglContext();
std::unique_ptr<Context> makeOsMesaContext();

// switchTo: notes that `next` is about to become current and, where another library's context was, releases
// that one first: an OSMesa and an EGL context must not be current together. Returns whether `next` was
// current already.
//   release  makes no context of next's library current
using Release = void (*)();
bool switchTo(const Context* next, Release release);

// forget: a context that is going away, or to another thread, is current on this one no longer.
void forget(const Context* gone);

}  // namespace sonoskin::gl
