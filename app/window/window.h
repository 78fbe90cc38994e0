#pragma once

#include <filesystem>
#include <optional>

#include "core/pipeline/parameters.h"

namespace sonoskin {

// openWindow: the interactive program; returns when the person closes it.
//   input    file        the volume to open; without one the phantom is simulated
//            parameters  what the sliders start with
//   output   exit status: 0
//   errors   Error (system): there is no display, or it has no OpenGL 4.5. Anything later is shown in the
//   window. threads  call on the main thread
int openWindow(const std::optional<std::filesystem::path>& file, const Parameters& parameters = {});

}  // namespace sonoskin
