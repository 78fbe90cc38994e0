#include "render/outline.h"

#include <glad/gl.h>

namespace sonoskin {
namespace {

constexpr int kSamples = 4;  // every OpenGL 4.5 has as many

}  // namespace

Outline::Outline()
    : program_({"common/outline.vert", "common/outline.frag"}),
      samples_({.size = {1, 1}, .colours = {gl::Format::r8}, .samples = kSamples}),
      shares_({.size = {1, 1}, .colours = {gl::Format::r8}}) {}

const gl::Texture& Outline::draw(glm::ivec2 size, const glm::mat4& viewProjection, const ClipPlane& clip,
                                 const std::function<void()>& triangles) {
  samples_.fit(size);
  shares_.fit(size);
  samples_.clear({});
  samples_.bind();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_MULTISAMPLE);
  program_.use();
  program_.set("viewProjection", viewProjection);
  {
    const ClipInUse clipped(program_, clip);
    triangles();
  }
  glDisable(GL_SCISSOR_TEST);
  glBlitNamedFramebuffer(samples_.name(), shares_.name(), 0, 0, size.x, size.y, 0, 0, size.x, size.y,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
  return shares_.colour();
}

}  // namespace sonoskin
