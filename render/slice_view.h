#pragma once

#include <array>
#include <optional>

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gpu_mask.h"
#include "render/gpu_volume.h"
#include "render/grey_window.h"
#include "render/slice_frame.h"

namespace sonoskin {

// SliceViewInput: what SliceView draws. The volumes may differ in resolution: they are placed by world
// position.
//   frame          the geometry whose axes the planes mean
//   volume         shown in grey; nothing where it is empty
//   overlay        may be null; its values, windowed, shown as `overlayColour` (sRGB) over the grey
//   overlayOpacity 0 to 1
//   tint           as overlay, below it
//   erased         may be null; of the frame's geometry; shown in `erasedColour` (sRGB) where it is not zero
//   box            two corners in the world, the lowest and the highest along the frame's axes: lines at its sides, and
//                  darker outside; not in an oblique slice
//   crossHair      the lines of the other two planes; not in an oblique slice
struct SliceViewInput {
  const Geometry& frame;
  const SliceCamera& camera;
  const GpuVolume& volume;
  GreyWindow window{};
  const GpuVolume* overlay = nullptr;
  GreyWindow overlayWindow{};
  glm::vec3 overlayColour{1.0f, 0.62f, 0.16f};
  float overlayOpacity = 1;
  const GpuVolume* tint = nullptr;
  GreyWindow tintWindow{};
  glm::vec3 tintColour{0.24f, 0.55f, 1.0f};
  float tintOpacity = 0.75f;
  const GpuMask* erased = nullptr;
  glm::vec3 erasedColour{0.85f, 0.20f, 0.35f};
  std::optional<std::array<glm::dvec3, 2>> box{};
  bool crossHair = true;
};

// SliceView: one slice, with right proportions; grey values go to the screen as they are (sRGB-encoded).
class SliceView {
 public:
  void draw(const SliceViewInput& input, const gl::Target& target);

 private:
  gl::Program& programFor(bool overlaid, bool erased, bool tinted);

  std::array<std::optional<gl::Program>, 8> programs_;  // made when first needed
};

}  // namespace sonoskin
