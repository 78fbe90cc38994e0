#pragma once

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gpu_volume.h"
#include "render/slice_frame.h"

namespace sonoskin {

// GreyWindow: which values are shown from black to white.
struct GreyWindow {
  float level = 0.5f;  // middle
  float width = 1;     // > 0
};

// SliceViewInput: what SliceView draws. The volumes may differ in resolution: they are placed by world
// position.
//   frame          the geometry whose axes the planes mean
//   volume         shown in grey; nothing where it is empty
//   overlay        may be null; its values, windowed, shown as `overlayColour` (sRGB) over the grey
//   overlayOpacity 0 to 1
//   crossHair      the lines of the other two planes
struct SliceViewInput {
  const Geometry& frame;
  const SliceCamera& camera;
  const GpuVolume& volume;
  GreyWindow window{};
  const GpuVolume* overlay = nullptr;
  GreyWindow overlayWindow{};
  glm::vec3 overlayColour{1.0f, 0.62f, 0.16f};
  float overlayOpacity = 1;
  bool crossHair = true;
};

// SliceView: one slice, with right proportions; grey values go to the screen as they are (sRGB-encoded).
class SliceView {
 public:
  SliceView();

  void draw(const SliceViewInput& input, const gl::Target& target);

 private:
  gl::Program plainProgram_, overlayProgram_;
};

}  // namespace sonoskin
