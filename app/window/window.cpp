#include "app/window/window.h"

#include "app/window/application.h"

namespace sonoskin {

int openWindow(const std::optional<std::filesystem::path>& file, const Parameters& parameters) {
  Application application(file, parameters);
  while (application.frame()) {
  }
  return 0;
}

}  // namespace sonoskin
