#pragma once

#include "render/clip_plane.h"
#include "render/gpu_mesh.h"
#include "render/outline.h"
#include "render/surface_shading.h"

namespace sonoskin {

// MeshViewInput: what MeshView draws.
//   supersampling  1 for interaction; 2 for pictures (four samples per pixel, averaged in linear light, 16 for the outline)
//   unseenShade     0 to 1: how far regions that the probe cannot have seen, or that were not measured, are greyed
//   shadowSize      texels along the shadow map's side
//   clip            what it cuts off is not there, and casts no shadow
struct MeshViewInput {
  const GpuMesh& mesh;
  const Camera& camera;
  Lighting lighting;
  MeshLook look = MeshLook::clay;
  int supersampling = 1;
  float unseenShade = 0;
  int shadowSize = 1024;
  ClipPlane clip{};
};

// MeshView: a lit surface with soft shadows of the key light and ambient occlusion, over a background.
// Both sides of the surface are shown, the inner one darker.
class MeshView {
 public:
  MeshView();

  void draw(const MeshViewInput& input, const gl::Target& target);
  // buffer: what was drawn last. surface: its normals and depths.
  const SurfaceBuffer& buffer() const { return buffer_; }
  const gl::Framebuffer& surface() const { return buffer_.surface; }

 private:
  gl::Program shadowProgram_, surfaceProgram_;
  SurfaceBuffer buffer_;
  SurfaceShading shading_;
  Outline outline_;
};

}  // namespace sonoskin
