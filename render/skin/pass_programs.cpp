#include "render/skin/pass_programs.h"

#include <fmt/format.h>

#include "core/skin/skin_material.h"

namespace sonoskin {

gl::Program& PassPrograms::use(const std::string& file, const std::vector<std::string>& defines) {
  auto& found = programs_[fmt::format("{} {}", file, fmt::join(defines, " "))];
  if (!found) found = std::make_unique<gl::Program>(std::vector<std::string>{vertexShader_, file}, defines);
  found->use();
  return *found;
}

void bindTo(gl::Program& program, const std::string& sampler, int unit, const gl::Texture& texture) {
  texture.bind(unsigned(unit));
  program.set(sampler.c_str(), unit);
}

gl::Texture specularTexture() {
  const SpecularTable& table = specularTable();
  std::vector<glm::vec2> texels;
  for (int m = 0; m < SpecularTable::kRoughnesses; ++m)
    for (int c = 0; c < SpecularTable::kCosines; ++c)
      texels.emplace_back(table.value[std::size_t(m * SpecularTable::kCosines + c)],
                          table.mean[std::size_t(m)]);
  gl::Texture texture(
      {.size = {SpecularTable::kCosines, SpecularTable::kRoughnesses, 0}, .format = gl::Format::rg16f});
  texture.upload(texels.data());
  return texture;
}

}  // namespace sonoskin
