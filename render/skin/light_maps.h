#pragma once

#include <array>

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/skin/light_rig.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// LightMaps: what each shadowing light sees of the surface: depths, and of light 0 where in the atlas it is. Triangles that face
// away are left out: an open shell that is lit from behind would glow all over. Their depths, where light leaves the
// body, are a map of its own for light 0, which alone comes through thin parts.
//   a modified translucent shadow map                                        [GPU Gems 3, ch. 14.5.4; theory/skin.md, 4.2, 7.1]
class LightMaps {
 public:
  LightMaps();

  // draw: the map of light number i, of `most` texels a side, or so many that two lie along one of the atlas.
  void draw(const GpuSkin& surface, const LightRig& lights, std::size_t i, int most);
  // giveBack: the memory of all of them; what setLights has stays.
  void giveBack();
  // setLights: the uniforms of shaders/skin/lights.glsl.
  void setLights(gl::Program& program, const LightRig& lights) const;
  const gl::Texture& depth(std::size_t light) const { return maps_[light].target.depth(); }
  const gl::Texture& place() const { return maps_[0].target.colour(); }
  const gl::Texture& exit(std::size_t light) const { return maps_[light].exits.depth(); }
  std::size_t bytes() const;

 private:
  struct Map {
    gl::Framebuffer target, exits;
    glm::mat4 toMap{1};  // world -> 0 .. 1
    glm::vec2 terms{0};  // see lights.glsl
    float texel = 1;     // mm
  };
  void drawFacing(const GpuSkin& surface, const glm::mat4& view, unsigned culled, const gl::Framebuffer& to);

  gl::Program program_, hiddenProgram_;
  std::array<Map, LightRig::kMost> maps_;
};

// kindDefine: the define of shaders/skin/lights.glsl for a rig.
std::string kindDefine(const LightRig& lights);

}  // namespace sonoskin
