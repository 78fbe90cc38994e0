#pragma once

#include <optional>
#include <vector>

#include "render/gl/texture.h"

namespace sonoskin::gl {

// FramebufferDescription: the textures a pass draws into.
struct FramebufferDescription {
  glm::ivec2 size{0};
  std::vector<Format> colours{Format::rgba8};
  std::optional<Format> depth{};
  int samples = 1;
  Filter filter = Filter::nearest;  // how later passes read the colours
  bool depthCompare = false;        // later passes compare with the depth (shadow maps)
};

// Framebuffer: textures to draw into, of one size.
//   errors  Error (system): the driver cannot hold it, or not draw into it
class Framebuffer {
 public:
  Framebuffer() = default;
  explicit Framebuffer(const FramebufferDescription& description);

  // fit: remakes it where the size differs; the content is lost then. Where that fails it stays as it is.
  void fit(glm::ivec2 size);
  // bind: draws go here, to the whole of it.
  void bind() const;
  void clear(const glm::vec4& colour) const;  // all colours, and the depth to 1
  void clearDepth() const;                    // to 1

  // setTexels: fills a colour as Texture::upload does, instead of drawing it.
  void setTexels(std::size_t index, const void* texels) { colours_[index].upload(texels); }

  const Texture& colour(std::size_t index = 0) const { return colours_[index]; }
  const Texture& depth() const { return depth_; }
  glm::ivec2 size() const { return description_.size; }
  std::size_t texels() const { return std::size_t(size().x) * std::size_t(size().y); }
  unsigned name() const { return object_.name(); }
  explicit operator bool() const { return bool(object_); }

 private:
  struct Traits {
    static void destroy(unsigned name);
  };
  Object<Traits> object_;
  FramebufferDescription description_;
  std::vector<Texture> colours_;
  Texture depth_;
};

// Target: where a renderer draws: a framebuffer's name (0 is the window) and a rectangle of it, in pixels.
struct Target {
  unsigned framebuffer = 0;
  glm::ivec2 corner{0};
  glm::ivec2 size{0};

  Target() = default;
  Target(unsigned name, glm::ivec2 c, glm::ivec2 s) : framebuffer(name), corner(c), size(s) {}
  Target(const Framebuffer& f)
      : framebuffer(f.name()), size(f.size()) {}  // NOLINT: an implicit view is meant

  // bind: draws go here, and only here.
  void bind() const;
  // clear: binds it, and fills its first colour.
  void clear(const glm::vec4& colour) const;
};

// copyStretched: the first colour of a framebuffer over the whole target, interpolated.
void copyStretched(const Framebuffer& from, const Target& to);

}  // namespace sonoskin::gl
