#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "render/camera.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gpu_mask.h"
#include "render/gpu_volume.h"
#include "render/grey_window.h"
#include "render/light_volume.h"
#include "render/lighting.h"
#include "render/surface_shading.h"
#include "render/transfer_function.h"

namespace sonoskin {

// VolumeLook: surface: the first place along a ray where the value reaches `iso`; translucent: all that the
// transfer function shows, front to back; maximum: the largest value along a ray, as a grey.
enum class VolumeLook { surface, translucent, maximum };

// SurfaceBehind: a surface within a volume, drawn before it with the same camera.
//   buffer   whose depths end the rays
//   picture  of the whole target
struct SurfaceBehind {
  const SurfaceBuffer& buffer;
  const gl::Framebuffer& picture;
};

// RaycastInput: what Raycaster draws.
//   volume             nothing is drawn where it is empty
//   iso                0 to 1; bright is inside (surface)
//   transfer           (translucent)
//   shadows            whether what the key light has passed takes from it (translucent)
//   window             which values are black and white (maximum)
//   behind             may be null (translucent)
//   gradientReach      voxels to each side for the surface's normal; more is smoother
//   part               of the volume that is shown
//   erased             may be null; nothing is there where it is not zero. Of the same part of the world, perhaps finer
//   raysPerPixel       along one side: below 1 for interaction, 1, or 2 for pictures of surfaces
//   rows               of the picture that are cast, 0 to 1 from below: one may be cast over several draws that have all else
//                      in common, from 0 on, and comes to the target with the last
//   shadowSize         texels along the shadow map's side (surface)
struct RaycastInput {
  GpuVolume& volume;
  const Camera& camera;
  Lighting lighting;
  VolumeLook look = VolumeLook::surface;
  float iso = 0.5f;
  TransferFunction transfer{};
  bool shadows = true;
  GreyWindow window{};
  const SurfaceBehind* behind = nullptr;
  float gradientReach = 1;
  ShownPart part{};
  const GpuMask* erased = nullptr;
  float raysPerPixel = 1;
  glm::vec2 rows{0, 1};
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
  // translucent: the premultiplied colours and opacities that were drawn last, scene-linear (translucent) or display-linear
  // (maximum).
  const gl::Framebuffer& translucent() const { return translucent_; }

 private:
  void drawSurface(const RaycastInput& input, const gl::Target& target);
  void castSurface(const RaycastInput& input);
  void castShadow(const RaycastInput& input);
  void drawTranslucent(const RaycastInput& input, const gl::Target& target);
  void castTranslucent(const RaycastInput& input, float aspect);
  void castMaximum(const RaycastInput& input, float aspect);
  void finish(const RaycastInput& input, const gl::Target& target);
  void updateTransfer(const RaycastInput& input);
  void updateLight(const RaycastInput& input);

  // programFor: a program that casts rays or shows what they found, in the variant that the input asks for; made when first
  // needed.
  gl::Program& programFor(const char* file, std::vector<std::string> defines, const RaycastInput& input);

  std::map<std::string, gl::Program> programs_;
  SurfaceBuffer buffer_;
  gl::Framebuffer translucent_, small_;
  gl::Texture light_, transfer_;
  Volume<float> extinction_;
  Key transferKey_, extinctionKey_, lightKey_;
  SurfaceShading shading_;
};

}  // namespace sonoskin
