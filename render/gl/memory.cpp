#include "render/gl/memory.h"

#include "core/base/error.h"
#include "render/gl/context.h"

namespace sonoskin::gl {

void requireMade(bool made, const std::string& what) {
  const bool fits = !pollErrors().outOfMemory;
  if (made && fits) return;
  throw Error(
      fmt::format("The graphics driver cannot hold {}{}; make the window or the picture smaller, close other "
                  "programs, or use a smaller part of the volume.",
                  what, fits ? "" : " for lack of memory"),
      Error::Kind::system);
}

}  // namespace sonoskin::gl
