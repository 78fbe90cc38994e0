#pragma once

#include "render/outline.h"
#include "render/skin/detail_tile.h"
#include "render/skin/light_passes.h"

namespace sonoskin {

// PixelRect: a rectangle of pixels; the end is outside.
struct PixelRect {
  glm::ivec2 first{0}, end{0};
};

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
    bool shown = true;
    friend bool operator==(const Backdrop&, const Backdrop&) = default;
  };
  static void setBackdrop(gl::Program& program, const Backdrop& backdrop);
  void copyBackdrop(const Backdrop& backdrop, const gl::Target& to, glm::vec2 shownPart);
  // Canvas: what a picture's samples are drawn on.
  //   size   pixels, or samples of them
  //   part   where something can be seen of the surface
  //   kept   what the buffer of the surface holds
  struct Canvas {
    glm::ivec2 size{0};
    glm::mat4 projection{1};
    PixelRect part{}, kept{};

    // bind: draws go to a framebuffer that holds the canvas from `first` on.
    void bind(const gl::Framebuffer& to, glm::ivec2 first) const;
  };
  void drawSurface(const SkinViewInput& input, const Canvas& canvas);
  // colour, shade, showMap: of what is bound, which holds the canvas from `first` on.
  void colour(const SkinViewInput& input, const LightPasses& light, const Canvas& canvas, glm::ivec2 first);
  void shade(const SkinViewInput& input, const LightPasses& light, const Canvas& canvas, glm::ivec2 first);
  void showMap(const SkinViewInput& input, const LightPasses& light, glm::ivec2 toSurface);
  void drawInBands(const SkinViewInput& input, const LightPasses& light, const Canvas& canvas,
                   const Backdrop& backdrop, const gl::Target& target);
  void resolve(const SkinViewInput& input, const Backdrop& backdrop, const gl::Texture& outline, int firstRow,
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
