#pragma once

#include "render/outline.h"
#include "render/skin/detail_tile.h"
#include "render/skin/light_passes.h"

namespace sonoskin {

// FinalPass: from the light in the atlas to the picture: the only part that depends on the camera. The surface is drawn
// into a small buffer first and every pixel is shaded once.
class FinalPass {
 public:
  FinalPass();

  void draw(const SkinViewInput& input, LightPasses& light, const gl::Target& target);

 private:
  // Backdrop: what is behind the skin, drawn once and copied under every picture: its gradient would take a tenth of the time.
  struct Backdrop {
    glm::ivec2 size{0};
    glm::vec3 top{0}, bottom{0};
    friend bool operator==(const Backdrop&, const Backdrop&) = default;
  };
  void copyBackdrop(const Backdrop& backdrop, const gl::Target& to, glm::vec2 shownPart);
  void drawSurface(const SkinViewInput& input, glm::ivec2 size, const glm::mat4& projection);
  void shade(const SkinViewInput& input, const LightPasses& light, glm::ivec2 size,
             const glm::mat4& projection);
  void showMap(const SkinViewInput& input, const LightPasses& light);
  void resolve(const SkinViewInput& input, const Backdrop& backdrop, const glm::mat4& viewProjection,
               const gl::Target& target);

  PassPrograms programs_{"common/fullscreen.vert"};
  gl::Program surfaceProgram_;
  gl::Framebuffer surface_, samples_, backdrop_;
  Outline outline_;
  Backdrop backdropOf_;
  DetailTile detail_;
  gl::Texture specularTable_, charts_;
  std::uint64_t chartsOf_ = 0;
};

}  // namespace sonoskin
