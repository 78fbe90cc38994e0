#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/io/image.h"
#include "render/gl/framebuffer.h"

namespace sonoskin::gl {

// readImage: the first colour of an rgba8 framebuffer as a picture, top row first, opaque unless its alpha is asked for.
Image readImage(const Framebuffer& framebuffer, bool alpha = false);

// readFloats: the texels of a colour or depth texture as floats, bottom row and first slice first, `components` per texel
// (1 for depth and one-channel formats, 4 for RGBA).
std::vector<float> readFloats(const Texture& texture, int components);

// readTexels: the same of a texture with four components.
std::vector<glm::vec4> readTexels(const Texture& texture);

}  // namespace sonoskin::gl
