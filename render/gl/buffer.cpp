#include "render/gl/buffer.h"

#include <glad/gl.h>

namespace sonoskin::gl {

Buffer::Buffer(const void* data, std::size_t bytes) : bytes_(bytes) {
  unsigned name = 0;
  glCreateBuffers(1, &name);
  object_ = Object<Traits>(name);
  if (bytes) glNamedBufferStorage(name, GLsizeiptr(bytes), data, 0);
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
