#pragma once

#include <array>
#include <memory>

#include "render/gl/program.h"
#include "render/surface_buffer.h"

namespace sonoskin {

// MeshLook: what a surface looks like: neutral clay, skin, the amber of ultrasound pictures, or the colours of its parts
// (makePartsMesh).
enum class MeshLook { clay, skin, amber, parts };

// setScreen: the uniforms of shaders/common/screen.glsl.
void setScreen(gl::Program& program, const Camera& camera, float aspect, const glm::mat4& projection);

// ShadingInput: a surface buffer and what it is shaded as.
//   size           mm, of the thing shown: the reach of occlusion and penumbra follow from it
//   unseenShade    0 to 1: how far regions that the probe cannot have seen are greyed
//   outline        for more than one sample per pixel: how much of each of them the surface covers, see Outline; without
//                  it the samples themselves are counted
struct ShadingInput {
  const SurfaceBuffer& buffer;
  MeshLook look = MeshLook::clay;
  float size = 1;
  float unseenShade = 0;
  const gl::Texture* outline = nullptr;
};

// SurfaceShading: from a surface buffer to a picture: lights, soft shadows, ambient occlusion, tone mapping,
// anti-aliasing in linear light, background, sRGB. Each pixel is shaded once, or once per sample at edges.
class SurfaceShading {
 public:
  SurfaceShading();

  void draw(const ShadingInput& input, const gl::Target& target);

 private:
  void occlude(const ShadingInput& input);
  gl::Program& shadeProgram(const ShadingInput& input);

  gl::Program occlusionProgram_;
  static constexpr int kVariants = 3;
  std::array<std::unique_ptr<gl::Program>, 4 * kVariants> shadePrograms_;  // compiled when first needed
  gl::Framebuffer occlusion_;
};

}  // namespace sonoskin
