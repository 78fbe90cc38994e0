#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/gl/program.h"
#include "render/gl/texture.h"

namespace sonoskin {

// PassPrograms: programs of one vertex shader by fragment shader and defines, each compiled when first needed.
class PassPrograms {
 public:
  explicit PassPrograms(std::string vertexShader) : vertexShader_(std::move(vertexShader)) {}
  // use: the program, in use.
  gl::Program& use(const std::string& file, const std::vector<std::string>& defines);

 private:
  std::string vertexShader_;
  std::map<std::string, std::unique_ptr<gl::Program>> programs_;
};

// bindTo: a sampler of the program reads the texture, through a texture unit.
void bindTo(gl::Program& program, const std::string& sampler, int unit, const gl::Texture& texture);

// specularTexture: the table of shaders/skin/reflection.glsl.
gl::Texture specularTexture();

}  // namespace sonoskin
