#pragma once

#include <array>
#include <memory>

#include "render/camera.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/lighting.h"

namespace sonoskin {

// MeshLook: what a surface looks like: neutral clay, skin, the amber of ultrasound pictures, or the colours of its parts
// (makePartsMesh).
enum class MeshLook { clay, skin, amber, parts };

// The descriptions of the targets that surfaces are drawn into; shaders/surface/shade.frag tells what they hold.
gl::FramebufferDescription surfaceBuffer();
gl::FramebufferDescription shadowBuffer();

// LightView: the parallel view from a far light that holds a box's sphere.
struct LightView {
  glm::vec3 centre{0}, toLight{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0};
  float radius = 1;  // mm; half the width, height and depth

  LightView() = default;
  LightView(const glm::vec3& toLight, const Box& box);
  glm::mat4 projection() const;
};

// depthTerms: x, y of distance = x / (y - depth) for a perspective projection; distance in mm along the view.
glm::vec2 depthTerms(const glm::mat4& projection);

// setScreen: the uniforms of shaders/common/screen.glsl.
void setScreen(gl::Program& program, const Camera& camera, float aspect, const glm::mat4& projection);

// ShadingInput: a surface buffer and what is needed to shade it.
//   surface        drawn with camera and projection, samplesPerSide^2 samples per pixel
//   shadow         drawn with lightView
//   size           mm, of the thing shown: the reach of occlusion and penumbra follow from it
//   unseenShade    0 to 1: how far regions that the probe cannot have seen are greyed
//   outline        for more than one sample per pixel: how much of each of them the surface covers, see Outline; without
//                  it the samples themselves are counted
struct ShadingInput {
  const gl::Framebuffer& surface;
  const gl::Framebuffer& shadow;
  const LightView& lightView;
  const Camera& camera;
  const Lighting& lighting;
  glm::mat4 projection{1};
  MeshLook look = MeshLook::clay;
  int samplesPerSide = 1;  // 1 or 2
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
  void occlude(const ShadingInput& input, glm::ivec2 size);
  gl::Program& shadeProgram(const ShadingInput& input);

  gl::Program occlusionProgram_;
  static constexpr int kVariants = 3;
  std::array<std::unique_ptr<gl::Program>, 4 * kVariants> shadePrograms_;  // compiled when first needed
  gl::Framebuffer occlusion_;
};

}  // namespace sonoskin
