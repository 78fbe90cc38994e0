#include "render/gl/framebuffer.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include "render/gl/memory.h"

namespace sonoskin::gl {

Framebuffer::Framebuffer(const FramebufferDescription& description) : description_(description) {
  const auto& d = description_;
  unsigned fbo = 0;
  glCreateFramebuffers(1, &fbo);
  object_ = Object<Traits>(fbo);
  const glm::ivec3 size(d.size, 0);
  std::vector<GLenum> attachments;
  for (const Format format : d.colours) {
    colours_.emplace_back(
        TextureDescription{.size = size, .format = format, .filter = d.filter, .samples = d.samples});
    attachments.push_back(GL_COLOR_ATTACHMENT0 + GLenum(attachments.size()));
    glNamedFramebufferTexture(fbo, attachments.back(), colours_.back().name(), 0);
  }
  glNamedFramebufferDrawBuffers(fbo, GLsizei(attachments.size()), attachments.data());
  if (d.depth) {
    depth_ = Texture({.size = size,
                      .format = *d.depth,
                      .filter = d.depthCompare ? Filter::linear : Filter::nearest,
                      .samples = d.samples,
                      .shadow = d.depthCompare});
    glNamedFramebufferTexture(fbo, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
  }
  requireMade(glCheckNamedFramebufferStatus(fbo, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
              fmt::format("a picture of {} x {} texels to draw into", d.size.x, d.size.y));
}

void Framebuffer::fit(glm::ivec2 size) {
  if (size == description_.size) return;
  auto description = description_;
  description.size = size;
  *this = Framebuffer(description);
}

void Framebuffer::bind() const { Target(*this).bind(); }

void Framebuffer::clear(const glm::vec4& colour) const {
  glDisable(GL_SCISSOR_TEST);
  for (std::size_t i = 0; i < colours_.size(); ++i)
    glClearNamedFramebufferfv(name(), GL_COLOR, GLint(i), &colour[0]);
  if (depth_) clearDepth();
}

void Framebuffer::clearDepth() const {
  const float far = 1;
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClearNamedFramebufferfv(name(), GL_DEPTH, 0, &far);
}

void Framebuffer::Traits::destroy(unsigned name) { glDeleteFramebuffers(1, &name); }

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(corner.x, corner.y, size.x, size.y);
  glEnable(GL_SCISSOR_TEST);
  glScissor(corner.x, corner.y, size.x, size.y);
}

void Target::clear(const glm::vec4& colour) const {
  bind();
  glClearBufferfv(GL_COLOR, 0, &colour[0]);
}

void copyStretched(const Framebuffer& from, const Target& to) {
  glDisable(GL_SCISSOR_TEST);
  const glm::ivec2 end = to.corner + to.size;
  glBlitNamedFramebuffer(from.name(), to.framebuffer, 0, 0, from.size().x, from.size().y, to.corner.x,
                         to.corner.y, end.x, end.y, GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

}  // namespace sonoskin::gl
