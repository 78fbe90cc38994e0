#include "render/gl/buffer.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include "render/gl/memory.h"

namespace sonoskin::gl {

Buffer::Buffer(const void* data, std::size_t bytes) : bytes_(bytes) {
  unsigned name = 0;
  glCreateBuffers(1, &name);
  object_ = Object<Traits>(name);
  if (!bytes) return;
  glNamedBufferStorage(name, GLsizeiptr(bytes), data, 0);
  GLint made = GL_FALSE;
  glGetNamedBufferParameteriv(name, GL_BUFFER_IMMUTABLE_STORAGE, &made);
  requireMade(made == GL_TRUE, fmt::format("{} MB of a surface", bytes >> 20));
}

void Buffer::Traits::destroy(unsigned name) { glDeleteBuffers(1, &name); }

VertexArray::VertexArray() {
  unsigned name = 0;
  glCreateVertexArrays(1, &name);
  object_ = Object<Traits>(name);
}

void VertexArray::attribute(unsigned location, int components, const Buffer& buffer) {
  glVertexArrayVertexBuffer(name(), location, buffer.name(), 0, components * int(sizeof(float)));
  glVertexArrayAttribFormat(name(), location, components, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(name(), location, location);
  glEnableVertexArrayAttrib(name(), location);
}

void VertexArray::indices(const Buffer& buffer) { glVertexArrayElementBuffer(name(), buffer.name()); }

void VertexArray::Traits::destroy(unsigned name) { glDeleteVertexArrays(1, &name); }

}  // namespace sonoskin::gl
