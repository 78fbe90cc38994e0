#pragma once

#include <glm/glm.hpp>

#include "render/gl/object.h"

namespace sonoskin::gl {

// Format: what a texel holds.
enum class Format { r8, r16, r32f, rg16, rg16f, rg32f, rgba8, rgba16f, rgba32f, depth32f };
enum class Filter { nearest, linear };
enum class Wrap {
  clampToEdge,
  clampToZero,  // outside the texture is 0
  repeat
};

// TextureDescription: a texture before it is made.
//   size   texels; z = 0 for a 2D texture
struct TextureDescription {
  glm::ivec3 size{0};
  Format format = Format::rgba8;
  Filter filter = Filter::linear;
  Wrap wrap = Wrap::clampToEdge;
  int samples = 1;      // > 1: multisampled, 2D only
  bool shadow = false;  // depth32f: lookups compare with a reference depth
};

// Texture: an immutable-size texture without mip levels.
//   errors  Error (system): the driver cannot hold it
class Texture {
 public:
  Texture() = default;
  explicit Texture(const TextureDescription& description);

  // upload: replaces all texels by tightly packed values, x fastest, of the kind the format names:
  // r8, rgba8: bytes; r16, rg16: 16-bit; the others: 32-bit floats.
  void upload(const void* texels);
  // uploadSlices: the same for some slices of a 3D texture alone; `texels` begin with those.
  void uploadSlices(int first, int count, const void* texels);
  // bind: shaders find it at texture unit `unit`.
  void bind(unsigned unit) const;

  unsigned name() const { return object_.name(); }
  glm::ivec3 size() const { return description_.size; }
  const TextureDescription& description() const { return description_; }
  explicit operator bool() const { return bool(object_); }

 private:
  struct Traits {
    static void destroy(unsigned name);
  };
  Object<Traits> object_;
  TextureDescription description_;
};

}  // namespace sonoskin::gl
