#pragma once

#include <filesystem>
#include <optional>

#include "app/desktop_window.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// Application: the window with all that is in it. frame() is one turn of its loop.
class Application {
 public:
  Application(const std::optional<std::filesystem::path>& file, const Parameters& parameters);

  // frame: waits for something to do, does it, draws; false when the window was closed.
  bool frame();

 private:
  void draw();

  DesktopWindow window_;
  std::optional<std::filesystem::path> file_;
  Parameters parameters_;
};

}  // namespace sonoskin
