#pragma once

#include <CLI/App.hpp>
#include <glm/glm.hpp>

#include "render/gl/context.h"

namespace sonoskin {

// addSizeOption: --size WxH, 16x16 to 8192x8192.
void addSizeOption(CLI::App& command, glm::ivec2& size);

// addBackendOption: --gl egl|osmesa.
void addBackendOption(CLI::App& command, gl::Backend& backend);

}  // namespace sonoskin
