#pragma once

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/lighting.h"

namespace sonoskin {

// FinishInput: scene-linear samples and how they came about.
//   samples        colour 0: RGBA16F (see shaders/common/finish.frag); depth as `projection` made it
//   supersampling  samples per pixel along one side
//   radius         reach of the ambient occlusion, mm; 0: none
struct FinishInput {
  const gl::Framebuffer& samples;
  const Lighting& lighting;
  glm::mat4 projection{1};
  int supersampling = 1;
  float radius = 0;
};

// Finish: the last passes of a picture: ambient occlusion, tone mapping, averaging of the samples,
// background, sRGB.
class Finish {
 public:
  Finish();

  // surface: samples of surfaces, alpha negative where there is none.
  void surface(const FinishInput& input, const gl::Target& target);
  // volume: premultiplied samples of translucent volumes; no occlusion.
  void volume(const FinishInput& input, const gl::Target& target);

 private:
  void occlude(const FinishInput& input, const gl::Target& target);
  static void compose(gl::Program& program, const FinishInput& input, const gl::Target& target);

  gl::Program occlusionProgram_, surfaceProgram_, volumeProgram_;
  gl::Framebuffer occlusion_;
};

}  // namespace sonoskin
