#pragma once

#include <vector>

#include "render/camera.h"
#include "render/gl/framebuffer.h"
#include "render/lighting.h"

namespace sonoskin {

// LightView: the parallel view from a far light that holds a box's sphere.
struct LightView {
  glm::vec3 centre{0}, toLight{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0};
  float radius = 1;  // mm; half the width, height and depth

  LightView() = default;
  LightView(const glm::vec3& toLight, const Box& box);
  glm::mat4 projection() const;
};

// SurfaceFrame: from where a surface is seen, and in which light.
//   box            world mm; holds the surface
//   pixels         of the picture
//   shadowSize     texels along the shadow map's side
struct SurfaceFrame {
  Camera camera;
  Lighting lighting;
  Box box;
  glm::ivec2 pixels{1};
  int samplesPerSide = 1;
  int shadowSize = 1024;
};

// surfaceTexels: the description of the targets that surfaces are drawn into: depth, and as shaders/surface/buffer.glsl has
// it the outward normal and how well the place is known; then what tells its material.
gl::FramebufferDescription surfaceTexels(const std::vector<gl::Format>& material = {});

// SurfaceBuffer: a surface as the camera sees it, and how deep its key light sees. Whoever has a surface fills it, by
// triangles or rays; what shades it (SurfaceShading) does not know who did.
//   surface   samplesPerSide^2 texels per pixel, drawn with camera and projection
//   shadow    depths, drawn with lightView
struct SurfaceBuffer {
  SurfaceFrame frame;
  glm::mat4 projection{1};
  LightView lightView;
  gl::Framebuffer surface, shadow;

  SurfaceBuffer();
  // begin: both empty, for another frame.
  void begin(const SurfaceFrame& next);
  glm::mat4 viewProjection() const { return projection * frame.camera.view(); }
};

// depthTerms: x, y of distance = x / (y - depth) for a perspective projection; distance in mm along the view.
glm::vec2 depthTerms(const glm::mat4& projection);

}  // namespace sonoskin
