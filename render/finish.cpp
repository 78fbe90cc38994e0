#include "render/finish.h"

#include <glad/gl.h>

namespace sonoskin {

Finish::Finish()
    : occlusionProgram_({"common/fullscreen.vert", "common/occlusion.frag"}),
      surfaceProgram_({"common/fullscreen.vert", "common/finish.frag"}, {"SURFACE"}),
      volumeProgram_({"common/fullscreen.vert", "common/finish.frag"}, {"VOLUME"}),
      occlusion_({.size = {1, 1}, .colours = {gl::Format::rg16f}}) {}

void Finish::occlude(const FinishInput& input, const gl::Target& target) {
  occlusion_.fit(target.size);
  if (input.radius <= 0) {
    occlusion_.clear({1, 1, 0, 0});
    return;
  }
  occlusion_.bind();
  glDisable(GL_BLEND);
  const glm::mat4& p = input.projection;
  auto& program = occlusionProgram_;
  program.use();
  input.samples.depth().bind(0);
  program.set("depthMap", 0);
  program.set("step", input.supersampling);
  program.set("tangents", glm::vec2(1 / p[0][0], 1 / p[1][1]));
  // From z_ndc = 2 depth - 1 = -p22 + p32 / distance of a perspective projection (p23 = -1).
  program.set("depthTerms", glm::vec2(-0.5f * p[3][2], 0.5f * (1 - p[2][2])));
  program.set("radius", input.radius);
  program.set("pixelsPerTangent", 0.5f * float(target.size.y) * p[1][1]);
  gl::drawFullScreen();
}

void Finish::compose(gl::Program& program, const FinishInput& input, const gl::Target& target) {
  target.bind();
  glDisable(GL_BLEND);
  program.use();
  input.samples.colour().bind(0);
  program.set("samples", 0);
  program.set("step", input.supersampling);
  program.set("backgroundTop", input.lighting.backgroundTop);
  program.set("backgroundBottom", input.lighting.backgroundBottom);
  program.set("exposure", input.lighting.exposure);
  gl::drawFullScreen();
}

void Finish::surface(const FinishInput& input, const gl::Target& target) {
  occlude(input, target);
  occlusion_.colour().bind(1);
  surfaceProgram_.set("occlusionMap", 1);
  compose(surfaceProgram_, input, target);
}

void Finish::volume(const FinishInput& input, const gl::Target& target) {
  compose(volumeProgram_, input, target);
}

}  // namespace sonoskin
