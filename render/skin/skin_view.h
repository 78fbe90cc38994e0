#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/skin/landmark_options.h"
#include "core/skin/skin_options.h"
#include "core/skin/skin_surface.h"
#include "render/camera.h"
#include "render/clip_plane.h"
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

// showsMap: whether a pass shows a map that light leaves on the surface, and not what the camera sees of it.
bool showsMap(SkinPass pass);

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
  const std::shared_ptr<const SkinSurface>& surface() const;
  const Box& box() const;

  // giveBackSky: the memory of what neither points nor the sum of their light read. giveBackMaps: that of all maps: the
  // triangles alone can be drawn then.
  void giveBackSky();
  void giveBackMaps();

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
//   background     without it, what is not covered is transparent
//   clip           cuts the surface as the camera sees it; light enters and spreads as in the whole one
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
  bool background = true;
  ClipPlane clip{};
};

// LightState: how far the light of a picture of skin has come, in this order.
enum class LightState {
  none,      // no light of this surface is there yet
  earlier,   // that of an earlier look is shown
  complete,  // that of the look
  refined    // spread better than by blurs, too
};

class LightPasses;

// SkinView: a surface as skin. Light is computed by LightPasses and kept until lights, material or surface change: turning
// the camera costs the final pass only.
class SkinView {
 public:
  SkinView();
  ~SkinView();
  SkinView(SkinView&&) noexcept;
  SkinView& operator=(SkinView&&) noexcept;

  void draw(const SkinViewInput& input, const gl::Target& target);
  // state: what the last draw showed, or shows if it is drawn again.
  LightState state() const;

  // relight: runs all passes of the light without drawing.
  //   errors   Cancelled
  void relight(const GpuSkin& surface, const SkinLook& look, const SkinQuality& quality,
               const Progress& progress = {});
  // relightOnce: the same for one picture: memory is given back as soon as no later pass needs it, the surface's maps among
  // it. Then draw shows this light alone, and no pass that showsMap.
  void relightOnce(GpuSkin& surface, const SkinLook& look, const SkinQuality& quality,
                   const Progress& progress = {});
  // light: the passes and their maps (render/skin/light_passes.h).
  LightPasses& light();
  const LightPasses& light() const;

  // Timing: milliseconds of the GPU for each pass when it ran last. Asking waits for those passes.
  struct Timing {
    double material = 0, lightMaps = 0, visibility = 0, irradiance = 0, blurs = 0, combine = 0, final = 0;

    // moved: of all that runs when a light has moved.
    double moved() const { return lightMaps + visibility + irradiance + blurs + combine; }
  };
  Timing timing() const;
  // mapBytes: memory of the maps on the GPU, the surface's included.
  std::size_t mapBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonoskin
