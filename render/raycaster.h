#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "render/camera.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gpu_mask.h"
#include "render/gpu_volume.h"
#include "render/lighting.h"
#include "render/surface_shading.h"
#include "render/transfer_function.h"

namespace sonoskin {

// VolumeLook: surface: the first place along a ray where the value reaches `iso`; translucent: all that the
// transfer function shows, front to back.
enum class VolumeLook { surface, translucent };

// RaycastInput: what Raycaster draws.
//   volume             of floats; nothing is drawn where it is empty
//   iso                0 to 1; bright is inside (surface)
//   transfer           (translucent)
//   gradientReach      voxels to each side for the surface's normal; more is smoother
//   cropMin, cropMax   the part of the volume that is shown, 0 to 1 along i, j, k
//   erased             may be null; nothing is there where it is not zero. Of the same part of the world, perhaps finer
//   raysPerPixel       along one side: below 1 for interaction, 1, or 2 for pictures of surfaces
//   shadowSize         texels along the shadow map's side (surface)
struct RaycastInput {
  GpuVolume& volume;
  const Camera& camera;
  Lighting lighting;
  VolumeLook look = VolumeLook::surface;
  float iso = 0.5f;
  TransferFunction transfer{};
  float gradientReach = 1;
  glm::vec3 cropMin{0}, cropMax{1};
  const GpuMask* erased = nullptr;
  float raysPerPixel = 1;
  int shadowSize = 384;
};

// Raycaster: a volume without a mesh. Rays start at a fixed, pixel-dependent fraction of a step, so that steps
// do not show as bands; bricks with nothing to see are leapt over.
class Raycaster {
 public:
  Raycaster();

  // draw: to the whole of the target, the background included.
  void draw(const RaycastInput& input, const gl::Target& target);
  // surface: the normals and depths that were drawn last (surface).
  const gl::Framebuffer& surface() const { return buffer_.surface; }
  // translucent: the premultiplied scene-linear colours and opacities that were drawn last (translucent).
  const gl::Framebuffer& translucent() const { return translucent_; }

 private:
  void drawSurface(const RaycastInput& input, const gl::Target& target);
  void castSurface(const RaycastInput& input);
  void drawTranslucent(const RaycastInput& input, const gl::Target& target);
  void castTranslucent(const RaycastInput& input, float aspect);
  void updateLight(const RaycastInput& input);

  // Caster: a program that casts rays, and its variant for a volume of which something is erased.
  struct Caster {
    const char* file;
    std::vector<std::string> defines{};
    std::array<std::optional<gl::Program>, 2> programs{};  // made when first needed
    gl::Program& programFor(const RaycastInput& input);
  };

  Caster surfaceCaster_{"volume/surface.frag"}, shadowCaster_{"volume/surface.frag", {"DEPTH_ONLY"}},
      translucentCaster_{"volume/translucent.frag"};
  gl::Program finishProgram_;
  SurfaceBuffer buffer_;
  gl::Framebuffer translucent_, small_;
  gl::Texture light_, transfer_;
  Key lightKey_;
  SurfaceShading shading_;
};

}  // namespace sonoskin
