#include "render/gl/read_pixels.h"

#include <glad/gl.h>

#include <algorithm>

namespace sonoskin::gl {

Image readImage(const Framebuffer& framebuffer, bool alpha) {
  const glm::ivec2 size = framebuffer.size();
  const std::size_t row = std::size_t(size.x) * 4;
  std::vector<std::uint8_t> bottomUp(row * std::size_t(size.y));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(framebuffer.colour().name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(bottomUp.size()),
                    bottomUp.data());
  for (std::size_t i = 3; i < bottomUp.size() && !alpha; i += 4) bottomUp[i] = 255;
  Image image;
  image.width = size.x;
  image.height = size.y;
  image.rgba.resize(bottomUp.size());
  for (int y = 0; y < size.y; ++y)
    std::copy_n(bottomUp.data() + row * std::size_t(size.y - 1 - y), row,
                image.rgba.data() + row * std::size_t(y));
  return image;
}

namespace {

// Room for all texels of a texture.
template <class T>
std::vector<T> roomFor(const Texture& texture, std::size_t perTexel) {
  const glm::ivec3 size = texture.size();
  return std::vector<T>(std::size_t(size.x) * std::size_t(size.y) * std::size_t(std::max(size.z, 1)) *
                        perTexel);
}

}  // namespace

std::vector<float> readFloats(const Texture& texture, int components) {
  auto values = roomFor<float>(texture, std::size_t(components));
  const bool depth = texture.description().format == Format::depth32f;
  const GLenum external = depth ? GL_DEPTH_COMPONENT : components == 1 ? GL_RED : GL_RGBA;
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(texture.name(), 0, external, GL_FLOAT, GLsizei(values.size() * sizeof(float)),
                    values.data());
  return values;
}

std::vector<glm::vec4> readTexels(const Texture& texture) {
  static_assert(sizeof(glm::vec4) == 4 * sizeof(float));
  auto texels = roomFor<glm::vec4>(texture, 1);
  glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT, GLsizei(texels.size() * sizeof(glm::vec4)),
                    texels.data());
  return texels;
}

}  // namespace sonoskin::gl
