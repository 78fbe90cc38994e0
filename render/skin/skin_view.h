#pragma once

#include <memory>

#include "core/skin/landmark_options.h"
#include "core/skin/point_diffusion.h"
#include "core/skin/skin_options.h"
#include "core/skin/skin_surface.h"
#include "render/camera.h"
#include "render/gl/framebuffer.h"
#include "render/skin/light_rig.h"

namespace sonoskin {

// SkinPass: what is shown: the finished skin, or one of the things that it is made of.
enum class SkinPass {
  skin,        // everything
  undiffused,  // the same without light spreading below the surface
  irradiance,
  blur1,
  blur2,
  blur3,
  blur4,
  blur5,
  diffused,
  through,
  specular,
  albedo,
  finish,
  shadow,
  occlusion,
  normal,
  curvature,
  stretch,
  charts
};
constexpr std::array<const char*, 19> enumNames(SkinPass) {
  return {"skin",      "undiffused", "irradiance", "blur1",    "blur2",  "blur3",  "blur4",
          "blur5",     "diffused",   "through",    "specular", "albedo", "finish", "shadow",
          "occlusion", "normal",     "curvature",  "stretch",  "charts"};
}

// SkinLook: everything about the skin's appearance but the surface and the camera.
struct SkinLook {
  SkinOptions skin;
  LandmarkOptions landmarks;
  LightRig lights;
};

// GpuSkin: a prepared surface on the GPU: vertices and maps. Several SkinViews may share one.
class GpuSkin {
 public:
  GpuSkin();
  ~GpuSkin();
  GpuSkin(GpuSkin&&) noexcept;
  GpuSkin& operator=(GpuSkin&&) noexcept;

  // set: uploads where the surface is another object than the last time; keeps it alive.
  //   errors  Error (system): the driver cannot hold it; then there is none
  void set(std::shared_ptr<const SkinSurface> surface);
  const SkinSurface* surface() const;
  const Box& box() const;

  struct Parts;  // for the passes alone
  const Parts& parts() const { return *parts_; }

 private:
  std::unique_ptr<Parts> parts_;
};

// SkinViewInput: what SkinView draws.
//   supersampling  1 for interaction; 2 for pictures
//   pass           what is shown
//   unseenShade    0 to 1: how far what was not measured is greyed
//   shownPart      left and right limit of the picture's columns that are drawn, 0 to 1: split views draw twice
//   steps          how many of the light passes may run now; those that are left run with the next draws, and the light
//                  that has spread is the last complete one meanwhile
struct SkinViewInput {
  const GpuSkin& surface;
  const Camera& camera;
  const SkinLook& look;
  SkinQuality quality;
  int supersampling = 1;
  SkinPass pass = SkinPass::skin;
  glm::vec2 shownPart{0, 1};
  int steps = 1000;
  float unseenShade = 0;
};

// SkinView: a surface as skin. Light is computed in the atlas and kept until lights, material or surface change: turning
// the camera costs the final pass only.
class SkinView {
 public:
  SkinView();
  ~SkinView();
  SkinView(SkinView&&) noexcept;
  SkinView& operator=(SkinView&&) noexcept;

  void draw(const SkinViewInput& input, const gl::Target& target);
  // complete: whether the last draw showed the light of its own look, not an earlier one.
  bool complete() const;

  // relight: runs the light passes without drawing; maps: the light in the atlas afterwards, level 0 (irradiance) to 5,
  // linear RGB with coverage in a, wide blurs in coarser maps; `diffused`: the weighted sum of levels 1 to 5 and the light through thin parts;
  // `albedo`; `finish` (roughness, gloss, wetness, vernix).
  void relight(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality);
  const gl::Texture& level(int level) const;
  const gl::Texture& diffused() const;
  const gl::Texture& albedo() const;
  const gl::Texture& finish() const;
  // firstWeight: of level 0, where `diffused` lacks the first Gaussian; 0 where it holds it.
  glm::vec3 firstWeight() const;
  // spread: what relight() makes of a given irradiance instead of the lights'.
  //   irradiance   atlas size, linear RGB premultiplied by coverage in a
  void spread(const GpuSkin& surface, const SkinOptions& skin, const std::vector<glm::vec4>& irradiance);
  // setLevels: puts light that has spread from point to point (diffuseInBlocks, of level 0) in the place of blurs 1 to 5
  // and keeps it until the light changes; the last draw must have been complete. byPoints: whether such light is shown.
  void setLevels(const GpuSkin& surface, const PointDiffusion::Levels& levels);
  bool byPoints() const;
  // setDiffused: puts another answer (the reference's) in the place of the diffused map and keeps it until the light
  // changes.
  //   rgba   atlas size, linear; as diffused(), but with all six terms: the irradiance of the first is not added
  void setDiffused(const std::vector<glm::vec4>& rgba);

  // Timing: milliseconds of the GPU for each pass when it ran last. Asking waits for those passes.
  struct Timing {
    double material = 0, lightMaps = 0, visibility = 0, irradiance = 0, blurs = 0, combine = 0, final = 0;
  };
  Timing timing() const;
  // mapBytes: memory of the maps on the GPU, the surface's included.
  std::size_t mapBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonoskin
