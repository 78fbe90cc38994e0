#pragma once

#include "render/camera.h"
#include "render/finish.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gpu_volume.h"
#include "render/lighting.h"
#include "render/transfer_function.h"

namespace sonoskin {

// VolumeLook: surface: the first place along a ray where the value reaches `iso`; translucent: everything
// that the transfer function shows, front to back.
enum class VolumeLook { surface, translucent };

// RaycastInput: what Raycaster draws.
//   volume             of floats; nothing is drawn where it is empty
//   iso                0 to 1; bright is inside (surface)
//   transfer           (translucent)
//   gradientReach      voxels to each side for the surface's normal; more is smoother
//   cropMin, cropMax   the part of the volume that is shown, 0 to 1 along i, j, k
//   raysPerPixel       along one side: below 1 for interaction, 1, or a whole number for pictures
//   shadows            of the key light
struct RaycastInput {
  GpuVolume& volume;
  const Camera& camera;
  Lighting lighting;
  VolumeLook look = VolumeLook::surface;
  float iso = 0.5f;
  TransferFunction transfer{};
  float gradientReach = 1;
  glm::vec3 cropMin{0}, cropMax{1};
  float raysPerPixel = 1;
  bool shadows = true;
};

// Raycaster: a volume without a mesh. Rays start at a fixed, pixel-dependent fraction of a step, so that
// steps do not show as bands; bricks with nothing to see are leapt over.
class Raycaster {
 public:
  Raycaster();

  // draw: to the whole of the target, the background included.
  void draw(const RaycastInput& input, const gl::Target& target);
  // samples: what was drawn last, before the finish: scene-linear colour, and depth for surfaces.
  const gl::Framebuffer& samples() const { return samples_; }

 private:
  void castSurface(const RaycastInput& input, const glm::mat4& projection);
  void castTranslucent(const RaycastInput& input);
  void updateLight(const RaycastInput& input);
  void finish(const RaycastInput& input, const glm::mat4& projection, const gl::Target& target);

  gl::Program surfaceProgram_, shadowedProgram_, translucentProgram_;
  gl::Framebuffer samples_, small_;
  gl::Texture light_, transfer_;
  Key lightKey_;
  Finish finish_;
};

}  // namespace sonoskin
