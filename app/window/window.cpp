#include "app/window/window.h"

#include "app/window/window_loop.h"

namespace sonoskin {

int openWindow(const std::optional<std::filesystem::path>& file, const Parameters& parameters) {
  WindowLoop loop(file, parameters);
  while (loop.frame()) {
  }
  return 0;
}

}  // namespace sonoskin
