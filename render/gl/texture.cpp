#include "render/gl/texture.h"

#include <glad/gl.h>

#include <fmt/format.h>

#include <array>

#include "render/gl/memory.h"

namespace sonoskin::gl {
namespace {

struct FormatInfo {
  GLenum internal, external, type;
};

FormatInfo info(Format format) {
  switch (format) {
    case Format::r8:
      return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
    case Format::r16:
      return {GL_R16, GL_RED, GL_UNSIGNED_SHORT};
    case Format::r32f:
      return {GL_R32F, GL_RED, GL_FLOAT};
    case Format::rg16:
      return {GL_RG16, GL_RG, GL_UNSIGNED_SHORT};
    case Format::rg16f:
      return {GL_RG16F, GL_RG, GL_FLOAT};
    case Format::rg32f:
      return {GL_RG32F, GL_RG, GL_FLOAT};
    case Format::rgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Format::rgba16f:
      return {GL_RGBA16F, GL_RGBA, GL_FLOAT};
    case Format::rgba32f:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case Format::depth32f:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  return {};
}

GLint wrapMode(Wrap wrap) {
  constexpr std::array<GLint, 3> modes{GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_REPEAT};
  return modes[std::size_t(wrap)];
}

void setSampling(unsigned name, const TextureDescription& d) {
  const GLint filter = d.filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(name, axis, wrapMode(d.wrap));
  if (!d.shadow) return;
  glTextureParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(name, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

std::string wordsFor(const TextureDescription& d) {
  if (d.size.z > 0) return fmt::format("a volume of {} x {} x {} texels", d.size.x, d.size.y, d.size.z);
  const std::string samples = d.samples > 1 ? fmt::format(" of {} samples", d.samples) : "";
  return fmt::format("a picture of {} x {} texels{}", d.size.x, d.size.y, samples);
}

}  // namespace

Texture::Texture(const TextureDescription& description) : description_(description) {
  const auto& d = description_;
  const bool multisampled = d.samples > 1;
  const GLenum target = d.size.z > 0   ? GL_TEXTURE_3D
                        : multisampled ? GL_TEXTURE_2D_MULTISAMPLE
                                       : GL_TEXTURE_2D;
  unsigned name = 0;
  glCreateTextures(target, 1, &name);
  object_ = Object<Traits>(name);
  const GLenum internal = info(d.format).internal;
  if (d.size.z > 0)
    glTextureStorage3D(name, 1, internal, d.size.x, d.size.y, d.size.z);
  else if (multisampled)
    glTextureStorage2DMultisample(name, d.samples, internal, d.size.x, d.size.y, GL_TRUE);
  else
    glTextureStorage2D(name, 1, internal, d.size.x, d.size.y);
  GLint made = GL_FALSE;
  glGetTextureParameteriv(name, GL_TEXTURE_IMMUTABLE_FORMAT, &made);
  requireMade(made == GL_TRUE, wordsFor(d));
  if (!multisampled) setSampling(name, d);
}

void Texture::upload(const void* texels) {
  const auto f = info(description_.format);
  const auto s = description_.size;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (s.z > 0)
    glTextureSubImage3D(name(), 0, 0, 0, 0, s.x, s.y, s.z, f.external, f.type, texels);
  else
    glTextureSubImage2D(name(), 0, 0, 0, s.x, s.y, f.external, f.type, texels);
  requireMade(true, wordsFor(description_));  // some drivers look for the memory only now
}

void Texture::uploadSlices(int first, int count, const void* texels) {
  const auto f = info(description_.format);
  const auto s = description_.size;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage3D(name(), 0, 0, 0, first, s.x, s.y, count, f.external, f.type, texels);
}

void Texture::bind(unsigned unit) const { glBindTextureUnit(unit, name()); }

void Texture::Traits::destroy(unsigned name) { glDeleteTextures(1, &name); }

}  // namespace sonoskin::gl
