#pragma once

#include <functional>

#include "render/clip_plane.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"

namespace sonoskin {

// Outline: how much of every texel of a picture a surface covers. Pictures shade few samples per pixel; where a surface
// ends against the background, four times as many are counted, so that borders and silhouettes have no steps.
class Outline {
 public:
  Outline();

  // draw: counts the samples of a target of `size` texels; for shaders/common/outline.glsl.
  //   input   triangles   draws them, positions (world mm) as vertex input 0, with the program in use
  //   output  r8, 0 to 1; stays until the next call
  const gl::Texture& draw(glm::ivec2 size, const glm::mat4& viewProjection, const ClipPlane& clip,
                          const std::function<void()>& triangles);

 private:
  gl::Program program_;
  gl::Framebuffer samples_, shares_;
};

}  // namespace sonoskin
