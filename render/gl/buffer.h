#pragma once

#include <cstddef>
#include <span>

#include "render/gl/object.h"

namespace sonoskin::gl {

// Buffer: memory of the GPU, filled once.
//   errors  Error (system): the driver cannot hold it
class Buffer {
 public:
  Buffer() = default;
  Buffer(const void* data, std::size_t bytes);
  template <class T>
  explicit Buffer(std::span<const T> values) : Buffer(values.data(), values.size_bytes()) {}

  unsigned name() const { return object_.name(); }
  std::size_t bytes() const { return bytes_; }

 private:
  struct Traits {
    static void destroy(unsigned name);
  };
  Object<Traits> object_;
  std::size_t bytes_ = 0;
};

// VertexArray: which buffers feed the vertex shader's inputs.
class VertexArray {
 public:
  VertexArray();

  // attribute: input `location` reads `components` floats per vertex, tightly packed, from `buffer`.
  void attribute(unsigned location, int components, const Buffer& buffer);
  void indices(const Buffer& buffer);
  unsigned name() const { return object_.name(); }

 private:
  struct Traits {
    static void destroy(unsigned name);
  };
  Object<Traits> object_;
};

}  // namespace sonoskin::gl
